// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Predicted hysteresis, as JSON has it.

#include <limits>
#include <string>

#include "setae/fields/describe.hpp"
#include "setae/output/hysteresis_output.hpp"
#include "setae/study/hysteresis.hpp"

namespace setae::output {

/// Hysteresis of a study with its answer in sentences.
struct HysteresisEntry {
    const study::Hysteresis* hysteresis;

    /// In one line.
    [[nodiscard]] std::string answer() const {
        constexpr std::size_t one_line = 100000;
        return hysteresis_answer(*hysteresis, one_line);
    }
};

}  // namespace setae::output

namespace setae::fields {

template <>
struct Described<output::HysteresisEntry> {
    using T = output::HysteresisEntry;
    static constexpr std::array rows{
        made<T>("answer", "the likeliest model, models that are not excluded beside it, and what would decide",
                [](const T& of) { return of.answer(); }),
        fields_of<T>([](const T& of) -> const study::Hysteresis& { return *of.hysteresis; }),
    };
    static constexpr Description description{
        "hysteresis", "hysteresis predicted from roughness, and models of W_ret compared with measured pairs", rows};
};

}  // namespace setae::fields
