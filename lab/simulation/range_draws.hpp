// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/bytes/toml_reader.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::simulation {

/// Numbers of a table of a recipe, drawn where the recipe gives a range.
class RangeDraws {
public:
    /// table: its name in full, which selects the numbers drawn.
    RangeDraws(std::uint64_t seed, const std::string& table);

    /// "1 um", or one drawn from ["1 um", "4 um"], log-uniform.
    /// @throws FormatError at a pair that is not 0 < from <= to.
    [[nodiscard]] std::optional<double> quantity(bytes::TomlReader& reader, const char* key,
                                                 const Dimension& dimension) const;
    [[nodiscard]] std::optional<double> number(bytes::TomlReader& reader, const char* key) const {
        return quantity(reader, key, dimension::none);
    }
    /// @throws FormatError where the key is missing, too.
    [[nodiscard]] double required(bytes::TomlReader& reader, const char* key, const Dimension& dimension) const;

private:
    numerics::RandomKey key_;
};

}  // namespace setae::simulation
