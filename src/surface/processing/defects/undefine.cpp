// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/undefine.hpp"

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "pipeline/step_record.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/contour.hpp"

namespace setae::processing {
namespace {

/// Sets heights undefined and returns their number.
Index undefine_heights(const Undefine& step, double* heights, Index n) {
    constexpr double unlimited = std::numeric_limits<double>::infinity(), single_precision = 1e-7;
    const double above = step.above.value_or(unlimited), below = step.below.value_or(-unlimited);
    const double value = step.value.value_or(undefined), reach = single_precision * std::abs(value);
    Index count = 0;
    for (Index i = 0; i < n; ++i) {
        const double h = heights[i];
        if (!(h > above || h < below || std::abs(h - value) <= reach)) continue;
        heights[i] = undefined;
        ++count;
    }
    return count;
}

}  // namespace

Processed apply(const Undefine& step, topography::Measurement measurement, parallel::Threads) {
    if (!step.value && !step.above && !step.below)
        throw InvalidArgument("undefine has none of value, above and below; expected one of them, such as value=0");
    StepRecord record{std::string(step_name(step)), {}, {}};
    std::visit(
        [&](auto& m) {
            const Index points = m.heights.size(), count = undefine_heights(step, m.heights.data(), points);
            if (m.heights.isNaN().all())
                throw UndefinedDataError(
                    fmt::format("{}: undefine leaves no height defined", topography::label(m.metadata)));
            if constexpr (std::same_as<std::decay_t<decltype(m)>, topography::Profile>)
                m = topography::defined_points(std::move(m));
            record.numbers.push_back(recorded_count("undefined_points", count));
            record.numbers.push_back(
                recorded("undefined_share", "", static_cast<double>(count) / static_cast<double>(points), "1"));
        },
        measurement);
    return {std::move(measurement), std::move(record)};
}

}  // namespace setae::processing
