// SPDX-License-Identifier: GPL-3.0-or-later
#include "autocorrelation_result.hpp"

#include "setae/core/constants.hpp"

namespace setae::scales {

FunctionOfScale empty_autocorrelation(Index distances, const topography::Metadata& metadata) {
    FunctionOfScale result;
    result.quantity = "autocorrelation";
    result.unit = "m2";
    result.distance = result.value = result.count = Array1D::Zero(distances);
    result.standard_error = Array1D::Constant(distances, undefined);
    result.metadata = metadata;
    return result;
}

}  // namespace setae::scales
