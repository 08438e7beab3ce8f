// SPDX-License-Identifier: GPL-3.0-or-later
#include "height_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace setae::formats {

std::vector<std::string> words_of_name(std::string_view name) {
    std::vector<std::string> words(1);
    bool small = false;
    for (const char character : name) {
        const auto c = static_cast<unsigned char>(character);
        const bool part = std::isalnum(c) != 0 || c >= 0x80;
        if ((!part || (small && std::isupper(c) != 0)) && !words.back().empty()) words.emplace_back();
        if (part) words.back() += static_cast<char>(c < 0x80 ? std::tolower(c) : c);
        small = std::islower(c) != 0;
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

bool is_height_name(std::string_view name) {
    static constexpr std::array<std::string_view, 14> heights{
        "height",    "heights", "topography", "topo",  "elevation", "elevations", "surface",
        "heightmap", "zsensor", "höhe",       "hoehe", "hauteur",   "altura",     "altezza"};
    const auto words = words_of_name(name);
    const auto own = words_of_name(name.substr(name.rfind('/') == std::string_view::npos ? 0 : name.rfind('/') + 1));
    if (!own.empty() && (own.front() == "z" || own.front() == "h")) {
        const bool whole_name = own.size() == 1 || own[1] == "trace" || own[1] == "retrace" || own[1] == "forward" ||
                                own[1] == "backward" || own[1] == "axis";
        if (whole_name) return true;
    }
    return std::any_of(words.begin(), words.end(), [](const std::string& word) {
        return std::find(heights.begin(), heights.end(), word) != heights.end();
    });
}

}  // namespace setae::formats
