// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "setae/answers/surface_request.hpp"
#include "setae/diagnostics/diagnose.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers {

/// The measurements of a file without any processing: for a container all, for other files the requested channel or
/// else the first with heights.
/// @throws what reading throws; InvalidArgument where no channel contains heights.
[[nodiscard]] std::vector<topography::Measurement> measurements_of(const std::string& path, const FileRequest& options);

/// Request of `setae check` without the files.
struct DiagnosisRequest {
    std::string tip_radius;
};

/// A file to be checked, with the origin of its measurements.
struct Suspect {
    std::string file;
    std::function<std::vector<topography::Measurement>()> measurements;
};

/// Problems of measurements, of each separately and in comparison with each other.
struct Diagnosis {
    std::vector<std::string> faultless;  ///< labels of those that nothing was found in
    std::vector<diagnostics::Finding> findings;
    std::vector<std::string> failures;  ///< failures of files that could not be checked
};

/// request: of all suspects.  every_measurement: the first failure is thrown.
/// @throws InvalidArgument where there is nothing to look at, and for a malformed radius.
[[nodiscard]] Diagnosis diagnosis(const std::vector<Suspect>& suspects, const DiagnosisRequest& request,
                                  parallel::Threads threads = {}, bool every_measurement = false);

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::diagnostics::Finding> {
    using T = diagnostics::Finding;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const Alert& { return of.alert; }),
        field<&T::effects>("effects", "effects on results"),
        inner<&T::alert>(),
    };
    static constexpr Description description{"", "problems of measurements", rows};
};
static_assert(setae::fields::complete<setae::diagnostics::Finding>);

template <>
struct setae::fields::Asked<setae::answers::DiagnosisRequest> {
    using R = answers::DiagnosisRequest;
    static constexpr std::array options{answers::tip_radius_option<&R::tip_radius>()};
};
