// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/figures/instrument_look.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

#include "setae/figures/figure.hpp"

namespace setae::figures {

InstrumentLook instrument_look(std::string_view type) {
    constexpr std::array<std::pair<std::string_view, int>, 6> places{
        {{"stylus", 0}, {"afm", 1}, {"tem", 2}, {"optical", 3}, {"confocal", 3}, {"interferometer", 3}}};
    constexpr int other = 4;
    std::string small(type);
    std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
    const auto* const found =
        std::find_if(places.begin(), places.end(), [&](const auto& place) { return place.first == small; });
    const int place = found == places.end() ? other : found->second;
    return {general_colours + place, place};
}

}  // namespace setae::figures
