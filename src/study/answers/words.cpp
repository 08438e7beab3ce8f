// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/words.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"

namespace setae::answers {

namespace {

template <class Words>
void require(const char* what, const std::string& word, const Words& words) {
    if (word.empty() || std::find(words.begin(), words.end(), word) != words.end()) return;
    throw InvalidArgument(fmt::format("{} '{}'; expected {}", what, word, fmt::join(words, ", ")));
}

}  // namespace

void require_word(const char* what, const std::string& word, const std::vector<std::string>& words) {
    require(what, word, words);
}
void require_word(const char* what, const std::string& word, std::span<const std::string_view> words) {
    require(what, word, words);
}

}  // namespace setae::answers
