// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "setae/core/estimate.hpp"

namespace setae {

/// Exponents of length, mass, time, temperature, amount of substance and electric current.
struct Dimension {
    std::array<int, 6> exponents{};

    friend bool operator==(const Dimension&, const Dimension&) = default;
    friend Dimension operator*(const Dimension& a, const Dimension& b);
    friend Dimension operator/(const Dimension& a, const Dimension& b);
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{{1, 0, 0, 0, 0, 0}};
inline constexpr Dimension area{{2, 0, 0, 0, 0, 0}};
inline constexpr Dimension wavevector{{-1, 0, 0, 0, 0, 0}};
inline constexpr Dimension time{{0, 0, 1, 0, 0, 0}};
inline constexpr Dimension velocity{{1, 0, -1, 0, 0, 0}};
inline constexpr Dimension temperature{{0, 0, 0, 1, 0, 0}};
inline constexpr Dimension force{{1, 1, -2, 0, 0, 0}};
inline constexpr Dimension pressure{{-1, 1, -2, 0, 0, 0}};
inline constexpr Dimension energy{{2, 1, -2, 0, 0, 0}};
inline constexpr Dimension surface_energy{{0, 1, -2, 0, 0, 0}};
inline constexpr Dimension stiffness{{0, 1, -2, 0, 0, 0}};
inline constexpr Dimension molar_mass{{0, 1, 0, 0, -1, 0}};
inline constexpr Dimension power_spectrum_1d{{3, 0, 0, 0, 0, 0}};
inline constexpr Dimension power_spectrum_2d{{4, 0, 0, 0, 0, 0}};
}  // namespace dimension

/// Allowed values of a quantity, SI.
struct Domain {
    double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
    bool open = false;                     ///< `lower` itself is excluded
    const char* words = "a finite value";  ///< wording in errors and in the pages on keys
};

namespace domain {
inline constexpr Domain finite{};
inline constexpr Domain positive{0.0, std::numeric_limits<double>::infinity(), true, "above 0"};
inline constexpr Domain non_negative{0.0, std::numeric_limits<double>::infinity(), false, "0 or above"};
inline constexpr Domain share{0.0, 1.0, false, "from 0 to 1"};
inline constexpr Domain poisson_ratio{0.0, 0.5, false, "from 0 to 0.5"};
inline constexpr Domain acute_angle{0.0, 1.5707963267948966, true, "above 0 and up to 90 deg"};
}  // namespace domain

/// @throws InvalidArgument for a value that is not finite or outside a domain; the message quotes `given`.
void require_within(const Domain& domain, double value, std::string_view given);

/// Requirements on a text: dimension and domain of its value.
struct Expected {
    Dimension dimension;
    Domain domain;
    constexpr Expected(const Dimension& of, const Domain& within = domain::finite) : dimension(of), domain(within) {}
};
[[nodiscard]] constexpr Expected positive(const Dimension& of) { return {of, domain::positive}; }
[[nodiscard]] constexpr Expected non_negative(const Dimension& of) { return {of, domain::non_negative}; }

/// A unit: factor to SI and dimension. "mJ/m2" is {1e-3, surface energy}.
struct Unit {
    double factor = 1.0;
    Dimension dimension{};
};

/// Unit from text.
///
/// Products with '*', '·', '.' or a blank, quotients with '/', exponents as "m2", "m^2", "m²", "m^-1", "m⁻¹"; SI
/// prefixes from f to G; m, g, s, K, mol, A, N, J, Pa, V, Hz, F, Å, min, h, "%", "1"; µ in each of its spellings ("um",
/// "µm" U+00B5, "μm" U+03BC, "~m"); gf, kgf, lbf, ozf, dyn, in, mil, µin, lb and oz, which are masses; words such as
/// "Millimeter", "microns", "newtons", "inches". "°C" is refused if a difference and a reading would differ.
/// @throws InvalidArgument for text that is no unit.
[[nodiscard]] Unit parse_unit(std::string_view text);

/// Factor to SI of a unit that must have the given dimension; "A" counts as Å if a length is expected.
/// @throws InvalidArgument for text that is no unit or has another dimension.
[[nodiscard]] double unit_factor(std::string_view text, const Dimension& expected);

/// SI value of a number with its unit, such as "37 mJ/m2", "1.1MPa", "8nm". A dimensionless number needs no unit; a
/// missing unit is otherwise an error, never 1.
/// @throws InvalidArgument for a missing or wrong unit, a malformed number, and one outside the domain.
[[nodiscard]] double parse_quantity(std::string_view text, const Expected& expected);

/// A value and its standard error in SI, from "37.0 ± 3.7 mJ/m2", "37.0 +- 3.7 mJ/m2" or without the second part
/// (exact); method "given". "1.2 to 1.3 mm" is a uniform distribution: its middle and (b − a)/√12, method
/// "rectangular"; the interval is the whole range (level 1). Source: JCGM 100:2008, 4.3.7.
/// @throws InvalidArgument as parse_quantity, for a standard error that is negative, not finite, or larger than a value
/// that must be above 0, and for a range whose ends are in the wrong order.
[[nodiscard]] Estimate parse_uncertain_quantity(std::string_view text, const Expected& expected);

/// SI unit of a dimension as spelled in JSON and CSV files: "J/m2", "1/m", "Pa", "1".
[[nodiscard]] std::string si_unit(const Dimension& dimension);

/// A number for readers, with the prefix that puts it in [1, 1000): format_value(3.7e-2, "J/m2") is "37.00 mJ/m²".
/// Units that setae does not print as results have no prefix.
[[nodiscard]] std::string format_value(double value, std::string_view si_unit, int significant_digits = 4);

}  // namespace setae
