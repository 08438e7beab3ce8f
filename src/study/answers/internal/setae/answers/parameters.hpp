// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/output/json.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::answers {

/// Request of `setae params`.
struct ParametersRequest {
    study::SurfaceInput surface;
    study::SurfaceAnalysisOptions analysis;
    bool every_measurement = false;  ///< the first failure of one is thrown, in place of parameters without it
};

/// Parameters that belong together: of one measurement's heights, or of the surface's spectrum.
struct ParameterGroup {
    std::string file, name;
    std::string purpose;  ///< purpose of these numbers
    std::vector<Quantity> quantities;
    std::optional<std::size_t> channel = {};  ///< that was taken where the file has several
};

/// Parameters of a surface: those of each measurement's heights, then those of its spectrum by the requested
/// conversion, then by the other one. Without groups where the surface failed.
struct Parameters {
    study::SurfaceResult surface;
    std::vector<ParameterGroup> groups;
    /// The numbers to quote: rms height, slope, curvature and true area of the waves inside the reliable band.
    std::vector<Quantity> headline;
    std::string levelling;  ///< trend removed from the heights before, by measurement; empty for a given spectrum
};

/// The headline in words: the numbers with their standard errors, their waves, the removed trend and the measurements.
[[nodiscard]] std::string headline_text(const Parameters& parameters);

/// @throws what reading throws where every measurement is requested.
[[nodiscard]] Parameters parameters(const ParametersRequest& request, parallel::Threads threads = {});

/// A list of quantities, each with "file", "measurement", "channel", "purpose" and "headline": whether it is one to
/// quote. Those carry "levelling", too.
[[nodiscard]] output::Json to_json(const Parameters& parameters);

}  // namespace setae::answers
