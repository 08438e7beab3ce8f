// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "setae/imaging/contour_trace.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/simulation/micrograph.hpp"
#include "setae/simulation/rough_curve.hpp"

namespace setae::validation {

/// A kind of rendered and traced picture.
struct ContourKind {
    std::string name;                     ///< "SNR 2 + fringe"
    simulation::RoughCurveOptions curve;  ///< size and key are those of the trial
    simulation::MicrographOptions picture;
    bool transposed = false;  ///< the curve runs downwards, with the sample to its right
    bool judged = true;       ///< else it shows a limit
};

/// The kinds of a trial, for pictures of size² pixels: self-affine curves, H = 0.8, of 16 px rms height, with waves
/// from the picture's width down to 10 px, where at SNR 2 their spectrum meets the density of noise; at the end kinds
/// whose waves go down to 3 px, which are not judged.
[[nodiscard]] std::vector<ContourKind> contour_kinds(long size);

struct ContourTrialOptions {
    int runs = 20;
    std::uint64_t first_seed = 1;
    long size = 1000;                ///< side of a picture [px], >= 200
    std::vector<std::string> kinds;  ///< kinds by name; empty: all
    std::string pictures;  ///< folder for every picture with true curve and trace drawn in, and for the points of the
                           ///< true curve; empty: not written
    /// Function that traces a picture; throws UndefinedDataError where it refuses one.
    std::function<imaging::ContourTrace(const imaging::FramePixels&)> tracer = [](const imaging::FramePixels& pixels) {
        return imaging::trace_contour(pixels);
    };
    parallel::Threads threads;
    std::function<void(int)> progress;  ///< pictures done; one call at a time
};

/// Longest waves [px] of the half decades in which spectra are compared; the last ends at 6 px, a third of Nyquist.
inline constexpr std::array<double, 5> spectrum_band_ends{1000.0, 316.2, 100.0, 31.62, 10.0};
inline constexpr double shortest_compared_wave = 6.0;

/// Comparison of a trace with the rendered curve. Lengths in pixels; NaN without a comparison.
struct ContourTrial {
    int run = 0;
    std::string kind;
    bool judged = true;   ///< as of the kind
    std::string refusal;  ///< why there is no trace
    int segments = 0;
    bool vacuum_mistaken = false;  ///< the trace runs with the sample on its left hand
    double completeness = 0.0;     ///< share of the curve's length within the picture that has a trace within 3 px
    double rms_error =
        0.0;  ///< root mean square distance along the normal, the larger of trace to curve and curve to trace
    double largest_error = 0.0;  ///< largest of both directions of comparison
    double offset = 0.0;         ///< mean of the trace's signed distance, positive in the vacuum
    double within_two_errors =
        0.0;  ///< share of the trace's points closer to the curve than two of their standard errors
    double rms_height_ratio = 0.0;  ///< Rq of the levelled trace over that of the curve
    /// C1D of the trace divided by that of the curve: mean over tenths of a decade with waves of the curve, ten times
    /// above the floor
    std::array<double, 5> spectrum_ratio{};
    /// C1D of the trace's errors between waves of 200 and 50 px, divided by the stated noise density; NaN where that is
    /// below 1e-4 px³
    double floor_ratio = 0.0;
    double smoothing_length = 0.0, edge_width = 0.0;  ///< as the trace states them
    int overhangs = 0, overhangs_found = 0,
        overhangs_false = 0;            ///< false: deeper than 1 px where the curve does not turn back
    double overhang_depth_ratio = 0.0;  ///< mean, of those found
};

/// Renders, traces and compares; every kind shows the same curve and noise in the same run.
///
/// Levelled curves are the upper envelope for overhangs, and cut for height and spectrum. Order: kinds, then runs.
/// @throws InvalidArgument for runs < 1, a size below 200, an unknown kind, no tracer; FileError where pictures cannot
/// be written.
[[nodiscard]] std::vector<ContourTrial> contour_trials(const ContourTrialOptions& options);

}  // namespace setae::validation
