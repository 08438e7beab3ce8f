// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "setae/core/arrays.hpp"
#include "setae/half_space/adhesive_cell.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::patches {

/// A periodic patch of a random rough surface on an elastic half-space with attraction.
///
/// Three ratios determine its behaviour: e = U_el/(A w), energy stored in full contact divided by gained energy;
/// ρ/h_rms; and its band, longest divided by shortest wavelength. Slopes are small to first order and do not enter.
struct PatchDesign {
    Index points = 256;             ///< number of points n per side
    double points_per_wave = 16.0;  ///< points per shortest wavelength, >= 4
    double waves_per_side = 4.0;    ///< longest wavelengths per side, >= 1
    double hurst_exponent = 0.8;    ///< H of the band, 0 < H <= 1
    double energy_share = 0.4;      ///< e > 0, exact
    double squared_ratio = 0.5;     ///< μ² = w dx/(E*ρ²) of the grid, which determines ρ; at most 1, 1/2 for 1 %
    half_space::AttractionLaw law = half_space::AttractionLaw::exponential;
    std::uint64_t seed = 1;
    /// C_iso of the band except for a factor, against the wavevector times a pixel's width; absent: self-affine with H.
    std::optional<spectra::SpectralDensity> spectrum = std::nullopt;

    [[nodiscard]] double band() const;  ///< longest divided by shortest wavelength
    /// Whether points, shortest wavelength and μ² are equal: these distinguish kinds of patches in a survey.
    [[nodiscard]] bool like(const PatchDesign& other) const {
        return points == other.points && points_per_wave == other.points_per_wave &&
               squared_ratio == other.squared_ratio;
    }
};

/// A patch in units of E* = w = a pixel's width = 1.
struct Patch {
    Array2D heights;
    half_space::Grid grid;
    half_space::Body body;
    half_space::Interaction interaction;
    double energy_share = 0.0;  ///< e
    double rms_height = 0.0, rms_slope = 0.0;

    [[nodiscard]] double range_over_height() const { return interaction.range / rms_height; }  ///< ρ/h_rms
};

/// Amplitudes are given by the spectrum, phases are drawn: height, slope and energy are equal for every seed. @throws
/// InvalidArgument for a design outside its domain, a band outside that of the grid, a spectrum without power in it.
[[nodiscard]] Patch make_patch(const PatchDesign& design, parallel::Threads threads = {});

}  // namespace setae::patches
