// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/figures/figure.hpp"

namespace setae::figures {
namespace {

bool is_letter(const std::string& title) { return title.size() == 1 && title[0] >= 'A' && title[0] <= 'Z'; }

}  // namespace

Heading heading_of(const Figure& figure, std::size_t panel) {
    const auto& [title, shows] = std::pair(figure.panels[panel].title, figure.panels[panel].shows);
    if (title.empty()) return {"", shows};
    if (is_letter(title)) return {title, shows};
    const auto words = title + (shows.empty() ? "" : ", " + shows);
    std::size_t titled = 0, before = 0;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        if (figure.panels[p].title.empty()) continue;
        ++titled;
        before += p < panel ? 1 : 0;
    }
    constexpr std::size_t letters = 26;
    if (titled < 2 || before >= letters) return {"", words};
    return {std::string(1, static_cast<char>('A' + before)), words};
}

}  // namespace setae::figures
