// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/height_summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::cli::info_command {
namespace {

HeightSummary summary_of(const Eigen::Ref<const Array1D>& heights) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    HeightSummary summary{.read = true, .undefined_count = heights.isNaN().count(), .points = heights.size()};
    const auto count = static_cast<double>(summary.points - summary.undefined_count);
    const double offset = summary.mean = heights.isNaN().select(0.0, heights).sum() / count;
    summary.standard_deviation = std::sqrt(heights.isNaN().select(0.0, heights - offset).square().sum() / count);
    summary.least = heights.isNaN().select(infinity, heights).minCoeff();
    summary.greatest = heights.isNaN().select(-infinity, heights).maxCoeff();
    return summary;
}

}  // namespace

bool can_be_read(const formats::ChannelInfo& info) {
    return info.is_height && !info.size.empty() && !info.unit.empty();
}

HeightSummary summarise(const formats::Channel& channel) {
    try {
        const auto measurement = channel.read();
        return std::visit(
            [](const auto& m) { return summary_of(Eigen::Map<const Array1D>(m.heights.data(), m.heights.size())); },
            measurement);
    } catch (const std::exception& error) {
        return {.error = reason_of(error)};
    }
}

}  // namespace setae::cli::info_command
