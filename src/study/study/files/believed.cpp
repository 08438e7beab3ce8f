// SPDX-License-Identifier: GPL-3.0-or-later
#include "believed.hpp"

#include <fmt/format.h>

#include "setae/core/units.hpp"

namespace setae::study {

std::string resolution_without_probe(const formats::ChannelInfo& info) {
    if (info.size.empty() || info.shape.empty() || !(info.shape.front() > 1)) return "waves are used down to two steps";
    const double step = info.size.front() / static_cast<double>(info.shape.front());
    return fmt::format("waves are used down to {}", format_value(2.0 * step, "m", 3));
}

}  // namespace setae::study
