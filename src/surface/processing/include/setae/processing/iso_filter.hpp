// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

/// Part of the heights that a filter keeps.
enum class Kept {
    long_waves,   ///< the mean line or surface: waviness, S-filter
    short_waves,  ///< heights minus it: roughness, L-filter
};
inline constexpr std::array<Choice<Kept>, 2> kept_names{
    {{"long_waves", Kept::long_waves}, {"short_waves", Kept::short_waves}}};

/// The Gaussian filter of ISO 16610-21 (lines) and 16610-61 (maps).
///
///   w_i = sum_j s(x_i − x_j) h_j / sum_j s(x_i − x_j),  s(x) = exp(−π (x/(α λc))²),  α = sqrt(ln 2/π)
///   transmission of a wavelength λ: 2^−(λc/λ)², 50 % at the cutoff; maps: s(x) s(y)
///
/// λc: cutoff [m]. The transmission is as stated to 1e-6 for λc >= 6 pixels; below, the sums over pixels differ from
/// the integral. The sums run over defined points: at ends and holes the weights are normalised over the existing
/// points (order 0: constants pass), or a local line or plane is fitted with these weights (order 1: planes pass up to
/// the border). Periodic data wrap. Undefined points remain undefined. The result equals these sums to 5e-8 of the
/// largest difference of heights: a Gaussian is truncated at 5.66 standard deviations, and a wide one is two narrower
/// ones on a coarse grid. Constants (order 0) and planes (order 1) pass to rounding. Cost O(n) for any cutoff: 4096²
/// points in 0.2 s on one core. Additional memory: from one more map (complete, order 0) to five (holes, order 1) for
/// cutoffs of a few pixels, almost none for wide ones. Source: ISO 16610-21:2011, 4; ISO 16610-61:2015, 4; ends: ISO
/// 16610-28:2016 (normalised weights; moments kept).
struct GaussianFilter {
    double cutoff = 0.0;  ///< nesting index λc [m], > 0
    Kept keep = Kept::long_waves;
    Index order = 0;  ///< of the local polynomial at ends and holes: 0 or 1
};

/// The robust Gaussian regression filter of ISO 16610-31 (lines) and 16610-71 (maps): insensitive to isolated grooves
/// and peaks.
///
///   minimises sum_j s(x_i − x_j) δ_j (h_j − polynomial_i(x_j))² at every i
///   δ = (1 − (r/c)²)² for |r| < c, otherwise 0;  r = h − w,  c = 4.4478 median |r|
///
/// Iterated from δ = 1 until c changes by less than a relative 1e-4, at most 50 times; once for constant data (c = 0).
/// Undefined without a point of nonzero weight nearby. Order 2 follows curvature; α then gives 50 % at λc: (1 + u)
/// exp(−u) = 1/2 at u = π α², α = 0.7309 (ISO 16610-31). Maps: polynomials of x and y up to that order together. The
/// transmission is that of the linear filter if all weights are equal; it is lower for a small wave in large noise.
/// Cost O(n) per iteration, order 2 on maps ten times that of order 0; memory up to eleven maps for cutoffs of a few
/// pixels.
struct RobustGaussianFilter {
    double cutoff = 0.0;  ///< nesting index λc [m], > 0
    Kept keep = Kept::long_waves;
    Index order = 2;  ///< of the local polynomial: 0, 1 or 2
};

/// The spline filter of ISO 16610-22, free ends; periodic data wrap. Maps: every line along x, then along y.
///
///   (1 + β α² P + (1 − β) α⁴ Q) w = h,  α = 1/(2 sin(π Δ/λc));  P, Q: squares of first, second differences, free ends
///   transmission: 1/(1 + β α² 4 sin²(πΔ/λ) + (1 − β) α⁴ 16 sin⁴(πΔ/λ)), 50 % at λc for every β
///
/// Undefined points have no weight: the spline continues through the gap. Robust (ISO 16610-32): heights weighted as in
/// RobustGaussianFilter; on maps the weights apply to the lines along x. Straight lines (β = 0) and constants pass;
/// errors are below 1e-15 α² of the heights. O(n).
struct SplineFilter {
    double cutoff = 0.0;  ///< λc [m], > 2 pixels
    Kept keep = Kept::long_waves;
    double tension = 0.0;  ///< β, 0 … 1
    bool robust = false;
};

/// The mean line or surface, or heights minus it, by Filter::keep.
/// @throws InvalidArgument for a cutoff or order outside its domain.
[[nodiscard]] topography::HeightMap filtered(topography::HeightMap map, const GaussianFilter& filter,
                                             parallel::Threads threads = {});
[[nodiscard]] topography::LineScan filtered(topography::LineScan scan, const GaussianFilter& filter,
                                            parallel::Threads threads = {});
[[nodiscard]] topography::HeightMap filtered(topography::HeightMap map, const RobustGaussianFilter& filter,
                                             parallel::Threads threads = {});
[[nodiscard]] topography::LineScan filtered(topography::LineScan scan, const RobustGaussianFilter& filter,
                                            parallel::Threads threads = {});
[[nodiscard]] topography::HeightMap filtered(topography::HeightMap map, const SplineFilter& filter,
                                             parallel::Threads threads = {});
[[nodiscard]] topography::LineScan filtered(topography::LineScan scan, const SplineFilter& filter,
                                            parallel::Threads threads = {});

/// @throws InvalidArgument also for polylines, whose points are not equally spaced: resample first.
[[nodiscard]] Processed apply(const GaussianFilter& filter, topography::Measurement measurement,
                              parallel::Threads threads = {});
[[nodiscard]] Processed apply(const RobustGaussianFilter& filter, topography::Measurement measurement,
                              parallel::Threads threads = {});
[[nodiscard]] Processed apply(const SplineFilter& filter, topography::Measurement measurement,
                              parallel::Threads threads = {});

inline constexpr std::string_view step_name(const GaussianFilter&) { return "gaussian_filter"; }
template <class Visitor>
void visit_parameters(GaussianFilter& step, Visitor& visitor) {
    visitor.length("cutoff", step.cutoff, "nesting index λc: half of a sine of this wavelength passes");
    visitor.choice("keep", step.keep, kept_names, "which part stays");
    visitor.count("order", step.order, "of the local polynomial at ends and holes: 0 or 1");
}

inline constexpr std::string_view step_name(const RobustGaussianFilter&) { return "robust_gaussian_filter"; }
template <class Visitor>
void visit_parameters(RobustGaussianFilter& step, Visitor& visitor) {
    visitor.length("cutoff", step.cutoff, "nesting index λc");
    visitor.choice("keep", step.keep, kept_names, "which part stays");
    visitor.count("order", step.order, "of the local polynomial: 0, 1 or 2");
}

inline constexpr std::string_view step_name(const SplineFilter&) { return "spline_filter"; }
template <class Visitor>
void visit_parameters(SplineFilter& step, Visitor& visitor) {
    visitor.length("cutoff", step.cutoff, "λc: half of a sine of this wavelength passes");
    visitor.choice("keep", step.keep, kept_names, "which part stays");
    visitor.number("tension", step.tension, "β, from 0 (only bending) to 1 (only stretching)");
    visitor.flag("robust", step.robust, "whether points that deviate strongly lose their weight");
}

}  // namespace setae::processing
