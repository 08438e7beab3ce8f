// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/quantity.hpp"
#include "setae/core/table.hpp"

namespace setae::tables {

/// What the first two columns are where the header does not say it; empty: as the header says.
struct SpectrumUnits {
    std::string quantity;             ///< of the first: "wavevector", "frequency" or "wavelength"
    std::string wavevector, density;  ///< units of the first and the second

    /// "1/um, nm3", or with what the first column holds: "frequency 1/um, nm3". @throws InvalidArgument for another
    /// number of units.
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
/// wavevectors, which metadata["converted"] says. What `units` say of the first column goes before its name:
///
///   q = 2π f = 2π/λ,  C1D(q) = C(f) where h_rms² = ∫ C(f) df over ±f
///
/// metadata["quantity"] is "wavevector", "frequency" or "wavelength", metadata["units_of_file"] the units as they were
/// taken, such as "1/um, nm3".
///
/// @throws FileError; InvalidArgument for units that contradict the header's; FormatError for one column only, units of
/// another dimension, wavevectors that repeat, or none that is positive. Source of the dialect: [D19]'s data, two
/// columns q [1/m] and C1D [m³]; of the conventions: [J17] sec. 2.
[[nodiscard]] Table read_power_spectrum_table(const std::string& path, const SpectrumUnits& units = {});

/// What a reader of such a table should know: UNIT_GUESSED, SPECTRUM_CONVERTED. `subject` is what they are about.
[[nodiscard]] std::vector<Alert> alerts_of(const Table& power_spectrum, const std::string& subject);

/// Whether the header of a text says that it is such a table: a second column in m³ or m⁴ beside one in 1/m or m.
[[nodiscard]] bool is_power_spectrum_table(const bytes::Source& source);

}  // namespace setae::tables
