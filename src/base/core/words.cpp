// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/words.hpp"

#include <fmt/format.h>

namespace setae {

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
    return fmt::format("{} {}", n == 0 ? "no" : std::to_string(n), n == 1 ? one : many);
}

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most = 6;
    const bool cut = names.size() > most;
    const auto shown = cut ? most - 1 : names.size();
    std::string text;
    for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : !cut && i + 1 == shown ? " and " : ", ") + names[i];
    return cut ? fmt::format("{} and {} more", text, names.size() - shown) : text;
}

}  // namespace setae
