// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/words.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"

namespace setae::answers {

void require_word(const char* what, const std::string& word, const std::vector<std::string>& words) {
    if (word.empty() || std::find(words.begin(), words.end(), word) != words.end()) return;
    throw InvalidArgument(fmt::format("{} '{}'; expected {}", what, word, fmt::join(words, ", ")));
}

}  // namespace setae::answers
