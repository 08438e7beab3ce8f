// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/tables/power_spectrum_table.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// Normalisation of a density.
enum class DensityKind {
    per_cycle,             ///< C1D(q) = C(f): h_rms² = (1/2π) ∫ C1D dq = ∫ C df over ±
    per_wavevector,        ///< W1: h_rms² = ∫ W1 dk over ±k, as in Gwyddion
    radial,                ///< Wr: h_rms² = ∫ Wr dk over k > 0
    areal,                 ///< C_iso: h_rms² = (1/2π) ∫ q C_iso dq
    areal_per_wavevector,  ///< W2: h_rms² = 2π ∫ k W2 dk
};

/// Content of a table of a spectrum.
struct SpectrumConvention {
    std::string quantity;  ///< of the first column: "wavevector", "frequency", "wavelength"
    DensityKind kind = DensityKind::per_cycle;
    bool one_sided = false;
    std::string density;  ///< name of the second column if it gives the kind: "C1D", "W1" …

    [[nodiscard]] bool areal() const { return kind == DensityKind::areal || kind == DensityKind::areal_per_wavevector; }
    /// Whether the columns are already wavevectors and C1D or C_iso.
    [[nodiscard]] bool own() const;
};

/// Wavevectors and C1D, or C_iso for areal and radial densities, in SI.
struct ConvertedSpectrum {
    bool areal = false;
    Array1D wavevector, factor;  ///< factor: multiplies the density
};

/// `abscissa`: the first column in SI.
[[nodiscard]] ConvertedSpectrum converted(const SpectrumConvention& convention, const Array1D& abscissa);

/// h_rms [m] of a surface with that C1D or C_iso and no longer waves; a power law between neighbours.
[[nodiscard]] double rms_height(const Array1D& wavevector, const Array1D& density, bool areal);

/// Conventions compatible with names, units and header lines; several if ambiguous, the most probable first.
[[nodiscard]] std::vector<SpectrumConvention> possible_conventions(const RawTable& table, const SpectrumUnits& stated);

/// "frequency, one-sided C1D", the input of SpectrumUnits::from_text(), with the stated units.
[[nodiscard]] std::string as_option(const SpectrumConvention& convention, const SpectrumUnits& stated);

/// "h_rms² = ∫ C df over ±f" …
[[nodiscard]] std::string normalisation(const SpectrumConvention& convention);

}  // namespace setae::tables
