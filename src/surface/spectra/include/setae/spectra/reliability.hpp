// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tiled_map.hpp"

namespace setae::spectra {

/// Options for the wavelengths that an instrument cannot resolve.
struct ReliabilityOptions {
    /// Share of positions whose curvature may exceed that of the tip at a reliable scale: 0 is the strict minimum,
    /// determined by the sharpest point; 0.001 ignores single noisy pixels.
    double percentile = 0.0;
    bool both_directions = false;   ///< maps: also along y, the worse direction is used
    double nyquist_fraction = 1.0;  ///< upper end of the band over π/(mean step): below 1 excludes the waves most
                                    ///< raised by aliasing
    int first_mode = 1;  ///< lower end of the band over 2π/L: above 1 excludes the waves distorted by window and
                         ///< detrending
};

/// Result of the tip-radius criterion.
enum class CutoffStatus {
    found,             ///< value is the cutoff
    all_reliable,      ///< even the shortest stencil (two steps) is blunter than the tip: value 0
    nothing_reliable,  ///< even the longest stencil is sharper than the tip: value is the size
};

/// Shortest wavelength resolved by a tip of finite radius.
struct TipCutoff {
    double value = 0.0;  ///< l_c [m]; use q < 2π/l_c only
    CutoffStatus status = CutoffStatus::found;
    double percentile = 0.0;           ///< 0: strict minimum
    std::optional<Interval> interval;  ///< 95 %, from the standard error of the tip radius
};

/// The cutoff of the second-difference criterion.
///
///   h''_l(x) = [h(x − l/2) − 2h(x) + h(x + l/2)]/(l/2)²,   min_x h''_l = −1/(2R) at l = l_c
///
/// R: tip radius [m]. Between points the heights are interpolated linearly; maps are evaluated along x (and y, see
/// options), with stencils centred on the grid points; for a profile the minimum is that of the polyline over all x.
/// Stencils run from half the size down to two (mean) steps, by halves until one is sharper than the tip; the root
/// between it and the previous one is the cutoff. If the criterion has several roots this is the largest. Periodic data
/// wrap; stencils with undefined heights are left out. With a percentile p the p-quantile of h''_l replaces the
/// minimum. Root to 1e-8; the result scales with the unit of length.
/// @throws InvalidArgument for R <= 0 or p outside 0 … 0.5, or a re-entrant profile.
/// Source: 10.1016/j.apsadv.2021.100190; [G18].
[[nodiscard]] TipCutoff tip_cutoff(const topography::HeightMap& map, double tip_radius,
                                   std::optional<double> tip_radius_standard_error = {},
                                   const ReliabilityOptions& options = {}, parallel::Threads threads = {});
[[nodiscard]] TipCutoff tip_cutoff(const topography::LineScan& scan, double tip_radius,
                                   std::optional<double> tip_radius_standard_error = {},
                                   const ReliabilityOptions& options = {}, parallel::Threads threads = {});
[[nodiscard]] TipCutoff tip_cutoff(const topography::Profile& profile, double tip_radius,
                                   std::optional<double> tip_radius_standard_error = {},
                                   const ReliabilityOptions& options = {}, parallel::Threads threads = {});
[[nodiscard]] TipCutoff tip_cutoff(const topography::Measurement& measurement, double tip_radius,
                                   std::optional<double> tip_radius_standard_error = {},
                                   const ReliabilityOptions& options = {}, parallel::Threads threads = {});

/// Wavevectors at which a measurement is reliable.
struct ReliableBand {
    Band band;                     ///< [2π first_mode/L, min(nyquist_fraction π/Δ, 2π/l_c, 2π/resolution)] [1/m]
    std::string upper_limit;       ///< origin of the upper end: "sampling", "tip radius" or "resolution"
    std::optional<TipCutoff> tip;  ///< if the instrument has a tip radius
    std::vector<Alert> alerts;     ///< TIP_CUTOFF: share of the band excluded by the tip
    [[nodiscard]] bool empty() const { return !(band.upper > band.lower); }
};

/// The band of a measurement along x, from its sampling and from the tip radius and resolution in its metadata.
[[nodiscard]] ReliableBand reliable_band(const topography::HeightMap& map, const ReliabilityOptions& options = {},
                                         parallel::Threads threads = {});
[[nodiscard]] ReliableBand reliable_band(const topography::LineScan& scan, const ReliabilityOptions& options = {},
                                         parallel::Threads threads = {});
[[nodiscard]] ReliableBand reliable_band(const topography::Profile& profile, const ReliabilityOptions& options = {},
                                         parallel::Threads threads = {});
/// Band of a map larger than memory: the cutoff of the worst of its bands of `lines_together` scan lines, which is that
/// of the whole map.
/// @throws InvalidArgument for a percentile above 0 or both_directions if the tip sets the limit: they need the whole
/// map.
[[nodiscard]] ReliableBand reliable_band(const topography::TiledMap& map, Index lines_together,
                                         const ReliabilityOptions& options = {}, parallel::Threads threads = {});
[[nodiscard]] ReliableBand reliable_band(const topography::Measurement& measurement,
                                         const ReliabilityOptions& options = {}, parallel::Threads threads = {});

}  // namespace setae::spectra
