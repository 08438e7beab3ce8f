// SPDX-License-Identifier: GPL-3.0-or-later
#include "probe_channels.hpp"

#include <algorithm>
#include <array>

#include "setae/bytes/text.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/header.hpp"

namespace setae::formats {

bool holds_heights(std::string_view name, std::string_view unit) {
    static constexpr std::array<std::string_view, 8> others{"amplitude",   "deflection",  "error",    "deformation",
                                                            "indentation", "dissipation", "friction", "phase"};
    const auto parsed = tables::try_parse_unit(unit);
    if (!parsed || parsed->dimension != dimension::length) return false;
    const auto lower = bytes::lowered(name);
    return std::none_of(others.begin(), others.end(),
                        [&](std::string_view other) { return lower.find(other) != std::string::npos; });
}

}  // namespace setae::formats
