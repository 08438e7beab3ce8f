// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/output/json.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::answers {

/// What `setae params` is asked.
struct ParametersRequest {
    study::SurfaceInput surface;
    study::SurfaceAnalysisOptions analysis;
    bool every_measurement = false;  ///< the first failure of one is thrown, in place of parameters without it
};

/// Parameters that belong together: of one measurement's heights, or of the surface's spectrum.
struct ParameterGroup {
    std::string file, name;
    std::string purpose;  ///< what these numbers are for
    std::vector<Quantity> quantities;
    std::optional<std::size_t> channel = {};  ///< that was taken where the file has several
};

/// Parameters of a surface: those of each measurement's heights, then those of its spectrum by the conversion asked
/// for, then by the other one. Without groups where the surface failed.
struct Parameters {
    study::SurfaceResult surface;
    std::vector<ParameterGroup> groups;
    /// The numbers to quote: rms height, slope, curvature and true area of the waves inside the reliable band.
    std::vector<Quantity> headline;
    std::string levelling;  ///< what was removed from the heights before, by measurement; empty of a given spectrum
};

/// The headline in words: the numbers with their ±, the waves they hold, what was removed and the measurements behind.
[[nodiscard]] std::string headline_text(const Parameters& parameters);

/// @throws what reading throws where every measurement is wanted.
[[nodiscard]] Parameters parameters(const ParametersRequest& request, parallel::Threads threads = {});

/// A list of quantities, each with "file", "measurement", "channel", "purpose" and "headline": whether it is one to
/// quote. Those carry "levelling", too.
[[nodiscard]] output::Json to_json(const Parameters& parameters);

}  // namespace setae::answers
