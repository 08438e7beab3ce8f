// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::answers {

/// An option that takes one of these words, or none. @throws InvalidArgument for another one.
void require_word(const char* what, const std::string& word, const std::vector<std::string>& words);

}  // namespace setae::answers
