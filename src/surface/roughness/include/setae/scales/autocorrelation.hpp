// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/scales/function_of_scale.hpp"
#include "setae/topography/tiled_map.hpp"

namespace setae::scales {

/// Definition of all autocorrelations here, by height differences,
///
///   A(d) = ½⟨[h(x + d) − h(x)]²⟩ [m²]
///
/// over all pairs of defined points a distance d apart; A → h_rms² for distances without correlation. Only a constant
/// is subtracted, so nine digits remain for offsets of 10⁷ h_rms. Distances without a pair are left out. Non-periodic
/// data: distances below the size, each with its existing pairs; periodic data: up to half the size, pairs wrap.
/// Source: Wang, Müser, Tribol. Int. 123 (2018) 224 (sign and factor).
struct AutocorrelationOptions {
    spectra::ReliabilityOptions reliability;
    parallel::Threads threads;
};

/// Autocorrelation of a line scan. O(n log n), with or without undefined heights.
/// @throws UndefinedDataError if no height is defined, InvalidArgument for fewer than two points along x (all functions
/// of lines).
[[nodiscard]] FunctionOfScale autocorrelation(const topography::LineScan& scan,
                                              const AutocorrelationOptions& options = {});

/// Autocorrelation of a map along its scan lines: the mean over pairs of all lines. One transform per line, one inverse
/// transform in total.
[[nodiscard]] FunctionOfScale autocorrelation_of_lines(const topography::HeightMap& map,
                                                       const AutocorrelationOptions& options = {});

/// Autocorrelation along the lines of a map larger than memory: only a band of at most `band_bytes` and sums over lines
/// are stored. A tip radius in the metadata needs a second pass, see spectra::reliable_band of a tiled map.
[[nodiscard]] FunctionOfScale autocorrelation_of_lines(const topography::TiledMap& map,
                                                       std::size_t band_bytes = std::size_t{1} << 28,
                                                       const AutocorrelationOptions& options = {});

/// Autocorrelation of a map over all directions: the mean of A(d) over all vectors d with length in a bin, the full
/// circle, up to the shorter side (half of it in periodic data), beyond which circles are incomplete. Bins of `grid`;
/// `distance` is the mean length, `count` the number of vectors. Additional memory: twice the map; six times with
/// undefined points. O(nx ny log(nx ny)).
[[nodiscard]] FunctionOfScale autocorrelation_of_area(const topography::HeightMap& map,
                                                      const spectra::LogGrid& grid = {},
                                                      const AutocorrelationOptions& options = {});

/// Autocorrelation over all directions up to a longest distance, for a map larger than memory: bands of scan lines
/// overlap by the longest lag. longest: [m], at least one pixel and below the shorter side (half of it in periodic
/// data). Memory: band_bytes, or sixteen times the lines within the longest lag if that is more. Reliable limit as for
/// lines.
/// @throws InvalidArgument for a longest distance outside its domain.
[[nodiscard]] FunctionOfScale autocorrelation_of_area(const topography::TiledMap& map, double longest,
                                                      const spectra::LogGrid& grid = {},
                                                      std::size_t band_bytes = std::size_t{1} << 28,
                                                      const AutocorrelationOptions& options = {});

/// Autocorrelation of a polyline, with exact integrals over its straight segments.
///
///   A(d) = 1/(2(L − d)) ∫ [h(x + d) − h(x)]² dx,  x = x_first … x_last − d
///
/// distances: 0 < d < L [m]; by default ten per decade, 10^(b/10) m, from the mean step on. O(points) per distance.
/// @throws InvalidArgument for a distance outside 0 < d < L or a re-entrant profile, UndefinedDataError for undefined
/// heights.
[[nodiscard]] FunctionOfScale autocorrelation(const topography::Profile& profile,
                                              const std::optional<Array1D>& distances = {},
                                              const AutocorrelationOptions& options = {});

/// Autocorrelation of any measurement along x: lines of a map, a line scan, a polyline.
[[nodiscard]] FunctionOfScale autocorrelation_along_lines(const topography::Measurement& measurement,
                                                          const AutocorrelationOptions& options = {});

/// Root-mean-square slope between points a distance d apart, sqrt(2A)/d [1], from the autocorrelation along lines.
[[nodiscard]] FunctionOfScale slope_from_autocorrelation(const FunctionOfScale& autocorrelation);

}  // namespace setae::scales
