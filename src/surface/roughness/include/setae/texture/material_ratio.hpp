// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/texture/measurement_view.hpp"

namespace setae::texture {

/// Interpolation between the points of a measurement.
enum class Between {
    linear,   ///< maps: two triangles per pixel, their common side from (i + 1, j) to (i, j + 1); lines: straight
              ///< segments
    nothing,  ///< none: the sampled definition of the standards; not for polylines
};

/// Share of the projected area at or above a height: the material ratio curve of the standards, also called bearing
/// area.
///
///   P(h) = |{x : z(x) >= h}| / |domain|
///
/// Exact for the interpolation: a triangle with heights a <= b <= c has the share 1 − (h − a)²/((b − a)(c − a)) for a <
/// h <= b and (c − h)²/((c − b)(c − a)) for b < h <= c; plateaus at h count as material. Triangles and segments with an
/// undefined corner are left out. Periodic data wrap. heights [m]: any number, in any order, NaN gives NaN. Cost: one
/// pass, and a step for each height inside each triangle. Same bytes for any number of threads.
/// @throws UndefinedDataError if no triangle, segment or point is defined.
/// Source: ISO 25178-2:2021, 4.5; ISO 21920-2:2021, 4.5.1.
[[nodiscard]] Array1D bearing_area(const MeasurementView& measurement, const ArrayView1D& heights,
                                   Between between = Between::linear, parallel::Threads threads = {});

/// The curve with the volume above each height.
struct MaterialRatioCurve {
    Array1D heights;       ///< h [m], increasing
    Array1D ratio;         ///< P(h) [1]
    Array1D volume;        ///< ∫_h^∞ P dh' = ⟨max(z − h, 0)⟩ [m³/m²], exact as P
    double mean = 0.0;     ///< of the interpolated heights [m]
    double lowest = 0.0;   ///< [m]
    double highest = 0.0;  ///< [m]
};

/// P and its integral at increasing heights.
/// @throws InvalidArgument for heights that do not increase; as bearing_area.
[[nodiscard]] MaterialRatioCurve material_ratio_curve(const MeasurementView& measurement, const ArrayView1D& heights,
                                                      Between between = Between::linear,
                                                      parallel::Threads threads = {});

/// The greatest heights that have at least the given ratios: H(p) = sup {h : P(h) >= p}; H(0) is the highest point.
///
/// Two passes for any number of ratios: one finds the brackets on 1024 intervals, one collects the elements with a
/// corner inside them, for which P is solved to the last digits. ratios: 0 … 1. @throws InvalidArgument outside 0 … 1;
/// as bearing_area.
[[nodiscard]] Array1D heights_at_ratio(const MeasurementView& measurement, const ArrayView1D& ratios,
                                       Between between = Between::linear, parallel::Threads threads = {});

/// The height exceeded by half of the projected area: H(1/2) [m].
[[nodiscard]] double median_height(const MeasurementView& measurement, Between between = Between::linear,
                                   parallel::Threads threads = {});

/// Half the width of the band about the median with the given share of the projected area [m].
///
///   P(median − m) − P(median + m) = share
///
/// For Gaussian heights and the default share erf(1/√2) = 68.27 % it is their rms; the median of deviations has share
/// 1/2.
/// @throws InvalidArgument for a share outside (0, 1).
inline constexpr double share_within_one_sigma = 0.682689492137085897;
[[nodiscard]] double mad_height(const MeasurementView& measurement, double share = share_within_one_sigma,
                                Between between = Between::linear, parallel::Threads threads = {});

}  // namespace setae::texture
