// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/instrument_words.hpp"

#include <cctype>
#include <map>

namespace setae::study {

std::vector<std::string> words_in_name(std::string_view name) {
    std::vector<std::string> words;
    bool within = false;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool letter = byte >= 0x80 || std::isalpha(byte) != 0;
        if (letter && !within) words.emplace_back();
        if (letter) words.back() += byte >= 0x80 ? c : static_cast<char>(std::tolower(byte));
        within = letter;
    }
    return words;
}

std::string instrument_of_word(std::string_view word) {
    static const std::map<std::string_view, const char*> words{{"stylus", "stylus"},
                                                               {"dektak", "stylus"},
                                                               {"profilometer", "stylus"},
                                                               {"afm", "afm"},
                                                               {"sfm", "afm"},
                                                               {"spm", "afm"},
                                                               {"tem", "tem"},
                                                               {"stem", "tem"},
                                                               {"hrtem", "tem"},
                                                               {"optical", "optical"},
                                                               {"confocal", "optical"},
                                                               {"interferometer", "optical"},
                                                               {"interferometry", "optical"},
                                                               {"wli", "optical"},
                                                               {"csi", "optical"}};
    const auto found = words.find(word);
    return found == words.end() ? "" : found->second;
}

std::string instrument_in_name(std::string_view name) {
    for (const auto& word : words_in_name(name))
        if (auto instrument = instrument_of_word(word); !instrument.empty()) return instrument;
    return "";
}

}  // namespace setae::study
