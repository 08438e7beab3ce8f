// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "setae/bytes/toml_reader.hpp"
#include "setae/simulation/stated_quantity.hpp"

namespace setae::simulation {

/// Quantities of a recipe with a standard error: each is drawn about its stated value, once per scope.
///
///   value = stated + ± n,  n a standard normal number of only the seed and the scope's name
///
/// "1.2 to 1.3 mm" is drawn uniformly between its ends.
class StatedDraws {
public:
    explicit StatedDraws(std::uint64_t seed) : seed_(seed) {}

    /// A quantity under a key of a table of the recipe. input: its scope and its name in the study, where several keys
    /// may share it; else empty, and table and key are its scope.
    /// @throws FormatError at the key where it is missing, where its scope has another value, and for a value that is
    /// drawn as 0 or less.
    [[nodiscard]] StatedQuantity required(bytes::TomlReader& reader, const std::string& table, const char* key,
                                          const Expected& expected, const std::string& input = "");

    /// The quantity with a drawn value, from a quantity that was read already. place: its name in errors at the key.
    [[nodiscard]] StatedQuantity drawn(StatedQuantity quantity, const std::string& place,
                                       const bytes::TomlReader& reader, const char* key);

private:
    struct StatedScope {
        StatedQuantity quantity;
        std::string place;
    };
    std::uint64_t seed_;
    std::map<std::string, StatedScope> scopes_;
};

/// Text of a quantity in the study, SI: "0.025 ± 0.001 J/m2", "0.0012 to 0.0013 m".
[[nodiscard]] std::string stated_text(const Estimate& stated_value, const std::string& unit);
[[nodiscard]] inline std::string stated_text(const StatedQuantity& quantity) {
    return stated_text(quantity.stated_value, quantity.unit);
}
/// The same as a key of the study has it: its name, where it has one.
[[nodiscard]] inline std::string mention(const StatedQuantity& quantity) {
    return quantity.input.empty() ? stated_text(quantity) : quantity.input;
}

}  // namespace setae::simulation
