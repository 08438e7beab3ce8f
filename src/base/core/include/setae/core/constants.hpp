// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <numbers>

namespace setae {

inline constexpr double pi = std::numbers::pi;

/// Molar gas constant R [J/(mol K)], exact in the SI of 2019.
inline constexpr double molar_gas_constant = 8.31446261815324;

/// The value of an undefined height or a missing table entry.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// SI units at literals: `500 * units::nm`.
namespace units {
inline constexpr double m = 1.0, mm = 1e-3, um = 1e-6, nm = 1e-9, angstrom = 1e-10, pm = 1e-12;
inline constexpr double N = 1.0, mN = 1e-3, uN = 1e-6, nN = 1e-9;
inline constexpr double Pa = 1.0, kPa = 1e3, MPa = 1e6, GPa = 1e9;
inline constexpr double J_per_m2 = 1.0, mJ_per_m2 = 1e-3;
inline constexpr double nJ = 1e-9, pJ = 1e-12, fJ = 1e-15;
}  // namespace units

}  // namespace setae
