// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace setae::study {

/// Words of a name in lower case, without the numbers after them: "rougher", "afm" of "rougher_AFM12.spm".
[[nodiscard]] std::vector<std::string> words_in_name(std::string_view name);

/// The instrument as a study calls it that a word names, such as "optical" of "confocal"; empty for any other word.
[[nodiscard]] std::string instrument_of_word(std::string_view word);

/// The same of the first word of a name that names one.
[[nodiscard]] std::string instrument_in_name(std::string_view name);

}  // namespace setae::study
