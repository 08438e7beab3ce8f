// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Further measurements, as the table and the JSON of `setae study --next` have them.

#include <array>
#include <string>
#include <vector>

#include "setae/adhesion/next_measurement.hpp"
#include "setae/fields/describe.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// Further measurements by their effect on the standard error of a result.
struct NextMeasurements {
    std::string target;  ///< the result, such as "W_int"
    std::vector<adhesion::NextMeasurement> measurements;
};

/// "another loop of E07 on rough".
[[nodiscard]] std::string words_of(const adhesion::Candidate& candidate);

/// One row per measurement, in order: standard error of the target with it [mJ/m²].
[[nodiscard]] tables::TidyTable next_table(const NextMeasurements& next);

}  // namespace setae::output

template <>
struct setae::fields::Described<setae::adhesion::NextMeasurement> {
    using T = adhesion::NextMeasurement;
    static constexpr std::array rows{
        made<T>("measurement", "the measurement, in words", [](const T& of) { return output::words_of(of.candidate); }),
        value<&T::standard_error>("standard_error", "J/m2", "standard error of the result with this measurement"),
        field<&T::gain>("gain", "relative reduction of the standard error"),
        made<T>("hours", "duration in hours", [](const T& of) { return of.candidate.hours; }),
        inner<&T::candidate>(),
    };
    static constexpr Description description{"", "a further measurement", rows};
};
static_assert(setae::fields::complete<setae::adhesion::NextMeasurement>);

template <>
struct setae::fields::Described<setae::output::NextMeasurements> {
    using T = output::NextMeasurements;
    static constexpr std::array rows{
        field<&T::target>("target", "result whose standard error is to be reduced"),
        field<&T::measurements>("measurements", "further measurements, the best first"),
    };
    static constexpr Description description{"", "with `--next` further measurements by their effect", rows};
};
static_assert(setae::fields::complete<setae::output::NextMeasurements>);
