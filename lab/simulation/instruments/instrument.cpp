// SPDX-License-Identifier: GPL-3.0-or-later
#include "instrument.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::simulation {
namespace {

std::optional<double> stated_radius(const topography::ArrayTip&) { return {}; }

template <class Shape>
std::optional<double> stated_radius(const Shape& shape) {
    return shape.radius;
}

}  // namespace

topography::Metadata simulated_with_tip(const std::string& type, const topography::Tip& tip,
                                        std::optional<double> tip_radius_standard_error) {
    topography::Metadata metadata;
    metadata.name = "simulated " + type;
    metadata.unit = "m";
    metadata.instrument = {"simulated " + type,
                           type,
                           std::visit([](const auto& shape) { return stated_radius(shape); }, tip),
                           tip_radius_standard_error,
                           {}};
    return metadata;
}

void require_not_negative(double value, const char* what) {
    if (!(value >= 0.0) || !std::isfinite(value))
        throw InvalidArgument(fmt::format("{} {}; expected finite, >= 0", what, value));
}

void require_finite(double value, const char* what) {
    if (!std::isfinite(value)) throw InvalidArgument(fmt::format("{} {}; expected finite", what, value));
}

}  // namespace setae::simulation
