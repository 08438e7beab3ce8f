// SPDX-License-Identifier: GPL-3.0-or-later
#include "autocorrelation_result.hpp"

#include <algorithm>

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

void limit_without_tip(FunctionOfScale& function, const topography::TiledMap& map) {
    const auto& instrument = map.metadata.instrument;
    function.reliable_from = 0.5 * std::max(2.0 * map.pixel_size()[0], instrument.resolution.value_or(0.0));
    if (instrument.tip_radius)
        function.alerts.push_back({"TIP_CUTOFF", topography::label(map.metadata), "what the tip cannot show is not cut: its cutoff needs the whole map in memory",
                                   "find the tip cutoff on a part of the map and leave out distances below half of it"});
}

}  // namespace setae::scales
