// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/bytes/source.hpp"
#include "setae/core/table.hpp"

namespace setae::tables {

/// Units of the first two columns where the header has none; empty: as the header says.
struct SpectrumUnits {
    std::string wavevector, density;

    /// "1/um, nm3". @throws InvalidArgument for another number of units.
    [[nodiscard]] static SpectrumUnits from_text(const std::string& text);
};

/// A power spectrum from a table: columns "wavevector" [1/m], ascending, and "C1D" [m³] or "C_iso" [m⁴]; a third column
/// is kept as "standard_error" where the header names it so.
///
/// Units stand in the header, as "q [1/m];C1D [m3]" or in a unit row; the density's tells C1D from C_iso. Two columns
/// without any unit are taken as SI, which metadata["units"] = "assumed SI" records; this covers separator ';' with
/// decimal comma and a first row that is no data.
///
/// A first column whose name says frequency ("frequency", "f", "1/lambda") is one, a length a wavelength; both become
/// wavevectors, which metadata["converted"] says:
///
///   q = 2π f = 2π/λ,  C1D(q) = C(f) where h_rms² = ∫ C(f) df over ±f
///
/// @throws FileError; InvalidArgument for units that contradict the header's; FormatError for one column only, units of
/// another dimension, wavevectors that repeat, or none that is positive. Source of the dialect: [D19]'s data, two
/// columns q [1/m] and C1D [m³]; of the conventions: [J17] sec. 2.
[[nodiscard]] Table read_power_spectrum_table(const std::string& path, const SpectrumUnits& units = {});

/// Whether the header of a text says that it is such a table: a second column in m³ or m⁴ beside one in 1/m or m.
[[nodiscard]] bool is_power_spectrum_table(const bytes::Source& source);

}  // namespace setae::tables
