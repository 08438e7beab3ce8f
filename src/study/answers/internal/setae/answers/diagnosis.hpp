// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "setae/answers/surface_request.hpp"
#include "setae/diagnostics/diagnose.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

/// The measurements of a file as they are, nothing removed: of a container every one, of other files the channel asked
/// for or else the first that holds heights.
/// @throws what reading throws; InvalidArgument where no channel holds heights.
[[nodiscard]] std::vector<topography::Measurement> measurements_of(const std::string& path, const FileRequest& options);

/// What `setae check` is told beside the files.
struct DiagnosisRequest {
    std::string tip_radius;
};

/// What is looked at: a file, and what gives its measurements.
struct Suspect {
    std::string file;
    std::function<std::vector<topography::Measurement>()> measurements;
};

/// What is wrong with measurements, each alone, then compared with each other.
struct Diagnosis {
    std::vector<std::string> faultless;  ///< labels of those that nothing was found in
    std::vector<diagnostics::Finding> findings;
    std::vector<std::string> failures;  ///< of files that could not be looked at
};

/// request: of all suspects.  every_measurement: the first failure is thrown.
/// @throws InvalidArgument where there is nothing to look at, and for a malformed radius.
[[nodiscard]] Diagnosis diagnosis(const std::vector<Suspect>& suspects, const DiagnosisRequest& request,
                                  parallel::Threads threads = {}, bool every_measurement = false);

/// Alerts with "effects".
[[nodiscard]] output::Json to_json(const Diagnosis& diagnosis);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::DiagnosisRequest> {
    using R = answers::DiagnosisRequest;
    static constexpr std::array options{answers::tip_radius_option<&R::tip_radius>()};
};
