// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/quantity.hpp"
#include "setae/core/table.hpp"

namespace setae::tables {

/// Meaning of the first two columns if the header lacks it; empty: as in the header.
struct SpectrumUnits {
    std::string quantity;             ///< of the first: "wavevector", "frequency" or "wavelength"
    std::string wavevector, density;  ///< units of the first and the second
    std::string sides;                ///< of the second: "one" or "two"
    std::string kind;                 ///< of the second: "C1D", "W1", "Wr", "C_iso" or "W2"

    /// "1/um, nm3", or with the content of the columns: "frequency 1/um, one-sided nm3", "wavevector, W1".
    /// @throws InvalidArgument for another number of columns.
    [[nodiscard]] static SpectrumUnits from_text(const std::string& text);
    [[nodiscard]] bool empty() const;
};

/// A power spectrum from a table: columns "wavevector" [1/m], ascending, and "C1D" [m³] or "C_iso" [m⁴]; a third column
/// is kept as "standard_error" if the header has this name.
///
/// Units are in the header, as "q [1/m];C1D [m3]" or in a unit row; the unit of the density distinguishes C1D from
/// C_iso. Two columns without any unit are taken as SI, and metadata["units"] is "assumed SI"; this covers separator
/// ';' with decimal comma and a first row that is no data.
///
/// A first column is a frequency by its name or unit ("frequency", "f", "1/lambda", "cycles/um"), a wavelength if it is
/// a length; both become wavevectors. A density is C1D (C_iso) or Gwyddion's W1, Wr or W2 by its name, one-sided by a
/// word of the header. `units` have priority over names; without either it is C1D of both signs, or C_iso:
///
///   q = 2π f = 2π/λ,  C1D(q) = C(f) if h_rms² = ∫ C(f) df over ±f,  C1D = P/2 for one-sided P
///   C1D = 2π W1 if h_rms² = ∫ W1 dk over ±k,  C_iso = 2π Wr/k if h_rms² = ∫ Wr dk,  C_iso = 4π² W2
///
/// metadata["converted"] is the conversion of the columns, metadata["assumed"] an assumption without support in the
/// file, both with h_rms; metadata["quantity"] is "wavevector", "frequency" or "wavelength", metadata["units_of_file"]
/// the units used, such as "1/um, nm3".
///
/// @throws FileError; InvalidArgument for units that contradict the header; FormatError for one column only, units of
/// another dimension, wavevectors that repeat, none that is positive, or an ambiguous density: the message lists the
/// readings with their h_rms and the option for each. Source of the dialect: [D19]'s data, two columns q [1/m] and C1D
/// [m³]; of the conventions: [J17] sec. 2; of W1, Wr, W2: Gwyddion's user guide, "Spectral density".
[[nodiscard]] Table read_power_spectrum_table(const std::string& path, const SpectrumUnits& units = {});

/// Warnings on such a table: UNIT_GUESSED, SPECTRUM_CONVERTED, SPECTRUM_CONVENTION. `subject` is that of the warnings.
[[nodiscard]] std::vector<Alert> alerts_of(const Table& power_spectrum, const std::string& subject);

/// Whether the header of a text describes such a table: a second column in m³ or m⁴ after one in 1/m or m.
[[nodiscard]] bool is_power_spectrum_table(const bytes::Source& source);

}  // namespace setae::tables
