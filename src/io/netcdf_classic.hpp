// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/io/source.hpp"

namespace setae::io {

/// A classic NetCDF file (CDF-1, -2, -5) in memory, every count and offset checked against the bytes there are; the
/// NetCDF library trusts damaged headers and crashes on them.
/// Source: NetCDF Classic Format Specification (netCDF Users Guide, appendix).
class ClassicNetcdf {
public:
    struct Attribute {
        std::string name;
        std::string text;             ///< of character attributes
        std::vector<double> numbers;  ///< of all others
    };
    struct Variable {
        std::string name;
        std::vector<Index> shape;
        std::vector<Attribute> attributes;
        std::uint32_t type = 0;
        std::uint64_t offset = 0;

        [[nodiscard]] std::string text(const std::string& attribute) const;  ///< empty where there is none
        [[nodiscard]] std::optional<double> number(const std::string& attribute) const;
    };

    /// @throws FormatError for a header that is damaged or truncated, or a variable along an unlimited dimension.
    explicit ClassicNetcdf(const Source& source);

    [[nodiscard]] const Variable* find(const std::string& name) const;

    /// All values of a variable in file order.
    [[nodiscard]] std::vector<double> values(const Variable& variable) const;

private:
    std::string name_;
    std::string content_;
    std::vector<Variable> variables_;
};

}  // namespace setae::io
