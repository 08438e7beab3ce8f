// SPDX-License-Identifier: GPL-3.0-or-later
#include "likelihood_spectrum.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::workflow {

void estimate_by_likelihood(SurfaceResult& surface, std::span<const PreparedMeasurement> prepared, const AnalysisOptions&, parallel::Threads) {
    throw UndefinedDataError(fmt::format("{}: no estimate by likelihood from its {} measurements; the average stands", surface.name, prepared.size()));
}

}  // namespace setae::workflow
