// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/fields/describe.hpp"
#include "setae/processing/processed.hpp"

/// A processing step that was applied, as JSON has it.
namespace setae::fields {

template <>
struct Described<processing::StepRecord> {
    using T = processing::StepRecord;
    static constexpr std::array rows{
        field<&T::step>("step", "name of the step in pipeline files"),
        field<&T::numbers>("numbers", "quantities that the step determined"),
        field<&T::alerts>("alerts", "warnings of the step"),
    };
    static constexpr Description description{"step", "a processing step that was applied", rows};
};
static_assert(complete<processing::StepRecord>);

}  // namespace setae::fields
