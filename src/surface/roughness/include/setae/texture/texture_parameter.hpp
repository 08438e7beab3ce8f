// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/quantity.hpp"

namespace setae::texture {

enum class Standard { iso25178, iso21920 };

/// One row of the table of parameters.
struct ParameterDefinition {
    std::string_view symbol;   ///< as in the standard, such as "Sq"
    std::string_view name;     ///< snake_case, such as "root_mean_square_height"
    std::string_view formula;  ///< in plain text
    std::string_view unit;     ///< SI
    Standard standard;
    std::string_view clause;     ///< of the standard
    std::string_view validated;  ///< comparison used for validation
};

/// Every parameter, in the order of the standards.
[[nodiscard]] std::span<const ParameterDefinition> parameters();

/// @throws InvalidArgument for a symbol that is not in the table, with the nearest one.
[[nodiscard]] const ParameterDefinition& parameter(std::string_view symbol);

/// Symbols in the table of parameters chosen by symbol or name, separated by commas or blanks, such as "Sq, Sdr".
/// letter: P, W or R, the first letter of symbols of lines; the table has R. @throws InvalidArgument for a parameter
/// not in the standard, with the nearest one.
[[nodiscard]] std::vector<std::string> chosen_parameters(std::string_view text, Standard standard, char letter = 'R');

/// A value of a parameter, and the filters applied before.
struct TextureParameter {
    Quantity quantity;  ///< its band is the bandwidth: 2π/(longest wavelength) … 2π/(shortest) [1/m]; its alerts are
                        ///< the warnings
    std::string filter;  ///< such as "S-filter 2.5 µm, L-filter 0.8 mm (Gaussian)", "none"

    /// Whether there are no warnings.
    [[nodiscard]] bool ok() const { return quantity.alerts.empty(); }
};

}  // namespace setae::texture
