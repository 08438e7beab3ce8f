// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "setae/core/arrays.hpp"
#include "setae/half_space/adhesive_cell.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::patches {

/// A periodic patch of a random rough surface under an elastic half-space that it attracts.
///
/// Three ratios decide what it does: e = U_el/(A w), how much of what contact gains full contact stores; ρ/h_rms; and
/// its band, longest over shortest wave. Slopes do not count, they are small to first order.
struct PatchDesign {
    Index points = 256;             ///< n, along a side
    double points_per_wave = 16.0;  ///< of the shortest wave, >= 4
    double waves_per_side = 4.0;    ///< of the longest wave, >= 1
    double hurst_exponent = 0.8;    ///< H of the band, 0 < H <= 1
    double energy_share = 0.4;      ///< e > 0, exact
    double squared_ratio = 0.5;     ///< μ² = w dx/(E*ρ²) of the grid, which sets ρ; at most 1, 1/2 for 1 %
    half_space::AttractionLaw law = half_space::AttractionLaw::exponential;
    std::uint64_t seed = 1;
    /// C_iso of the band but for a factor, of the wavevector times a pixel's width; absent: self-affine with H.
    std::optional<spectra::SpectralDensity> spectrum = std::nullopt;

    [[nodiscard]] double band() const;  ///< longest over shortest wave
    /// Whether points, shortest wave and μ² are the same: what tells kinds of patches in a survey apart.
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

/// Amplitudes are the spectrum's own, phases are drawn: height, slope and energy are the same for every seed.
/// @throws InvalidArgument for a design outside its domain, a band that the grid does not hold, a spectrum without
/// power in it.
[[nodiscard]] Patch make_patch(const PatchDesign& design, parallel::Threads threads = {});

}  // namespace setae::patches
