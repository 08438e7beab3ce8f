// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace setae::answers {

/// An option that takes one of these words, or none. @throws InvalidArgument for another one.
void require_word(const char* what, const std::string& word, const std::vector<std::string>& words);
void require_word(const char* what, const std::string& word, std::span<const std::string_view> words);

}  // namespace setae::answers
