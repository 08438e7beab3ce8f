// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/units.hpp"

namespace setae::tables {

/// The words of one role of columns of a loop, in lower case without accents.
struct Vocabulary {
    const char* role;
    Dimension dimension;
    std::vector<std::string> names;    ///< whole names of several words
    std::vector<std::string> words;    ///< whole names, or words within a name
    std::vector<std::string> symbols;  ///< whole names, case-sensitive
};

/// Force, displacement, contact radius and time in English, German, French, Spanish, Italian, Portuguese and Dutch.
[[nodiscard]] const std::vector<Vocabulary>& loop_vocabularies();

/// Match of a name, and why.
struct NamedRole {
    double confidence = 0.0;  ///< 0 without a match
    std::string reason;
};

[[nodiscard]] NamedRole named_role(const std::string& name, const Vocabulary& role);

/// Whether a name is that of a gap between the bodies, which decreases on approach.
[[nodiscard]] NamedRole named_gap(const std::string& name);

[[nodiscard]] bool names_contact_area(const std::string& name);

/// Whether a name contains a word that makes it another quantity: "force std", "lateral force".
[[nodiscard]] bool is_qualified(const std::string& name);

}  // namespace setae::tables
