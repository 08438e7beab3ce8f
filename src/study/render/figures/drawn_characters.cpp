// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_characters.hpp"

#include <map>
#include <mutex>

#include <fmt/format.h>

#include "setae/core/text.hpp"
#include "setae/platform/processes.hpp"

namespace setae::figures {
namespace {

/// Latin, Greek and Cyrillic letters, punctuation, raised and lowered digits: in the figures' own font.
bool in_own_font(char32_t code) {
    return code < 0x500 || (code >= 0x1e00 && code < 0x2000) || (code >= 0x2010 && code < 0x20a0);
}

/// Result of fc-list for a character; only a number is passed to the shell.
bool in_some_font(char32_t code) {
    constexpr char32_t first_of_asia = 0x2e80;
    const auto families =
        platform::output_of(fmt::format("fc-list ':charset={:x}' family 2>/dev/null", static_cast<unsigned>(code)));
    return families ? !families->empty() : code < first_of_asia;
}

}  // namespace

bool is_drawn(std::string_view character) {
    const auto code = code_point(character);
    if (in_own_font(code)) return true;
    static std::mutex mutex;
    static std::map<char32_t, bool> known;
    const std::lock_guard lock(mutex);
    const auto found = known.find(code);
    return found != known.end() ? found->second : known[code] = in_some_font(code);
}

}  // namespace setae::figures
