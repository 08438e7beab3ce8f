// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"
#include "setae/imaging/frames.hpp"

namespace setae::imaging {

/// Which side of the edge is vacuum.
enum class Vacuum { automatic, bright, dark };

/// A point that the trace must pass [px], places as FramePixels.
struct Anchor {
    double x = 0, y = 0;
};

/// How an edge is looked for. Lengths in pixels.
struct TraceOptions {
    Vacuum vacuum = Vacuum::automatic;
    /// One list a segment, in order along it. Two or more: the segment runs from the first to the last along the
    /// strongest edge between them; one: the nearest segment that is found without help is led through it. Empty: found
    /// without help.
    std::vector<std::vector<Anchor>> anchors;
    std::vector<PictureRegion>
        hidden;  ///< parts that show no sample, such as scale bars; the trace crosses them smoothly
    std::optional<double> smoothing_length;  ///< ℓ of the spline (0: none); unset: least expected error
    double denoise = 0.0;                    ///< standard deviation of a Gaussian that smooths the picture first
    std::optional<double> min_length;  ///< shorter segments are left out; unset: 50, of pictures with two grey levels 0
};

/// One stretch of the boundary, vacuum on the left hand of who walks along it as the picture is seen: above a curve
/// that runs to the right.
struct ContourSegment {
    Array1D x, y;                      ///< [px]; about one point a pixel of length, of a binary picture its corners
    Array1D standard_error;            ///< of each place along the normal [px]; 1/√12 of a binary picture
    bool closed = false;               ///< an outline: the last point is joined to the first
    double length = 0;                 ///< [px]
    std::vector<std::size_t> anchors;  ///< points that are anchors
    double edge_width = 0;             ///< w: standard deviation of the blur across the edge [px]
    double smoothing_length = 0;       ///< ℓ of the spline along the contour [px]
    double noise_density = 0;          ///< N: of places before smoothing, variance of one times its spacing, with the
                                       ///< correlation of neighbours [px³]
    double contrast_to_noise =
        0;                ///< of the step that has the edge's slope and width, over the noise of a pixel on either side
    bool fringe = false;  ///< a Fresnel fringe stands out
    bool converged = true;
};

/// What a picture gave.
struct ContourTrace {
    std::vector<ContourSegment> segments;       ///< in the order of anchors, else longest first
    Vacuum vacuum = Vacuum::automatic;          ///< as found
    bool binary = false;                        ///< two grey levels: outlines run along the borders of pixels, exactly
    double vacuum_level = 0, vacuum_noise = 0;  ///< median and standard deviation of a pixel
    double sample_level = 0, sample_noise = 0;  ///< the latter with the sample's own structure
    std::vector<Alert> alerts;  ///< TWO_EDGES, VACUUM_ASSUMED, LOW_CONTRAST, NOT_CONVERGED, SPIKES, UNDEF
};

/// Traces the boundary between vacuum and sample.
///
///   segmentation → outline → edge profile across it fitted over and over: two_phases.hpp, edge_refine.hpp
///
/// standard_error² = (1/π) ∫ [(1 − K)² S + K² N] dq: what the spline takes from the edge (spectrum S) and what it
/// leaves of noise, K = 1/(1 + ℓ⁴ (2 − 2 cos q)²). Spectra of the trace are T² S + K² N, T = K exp(−q² w²/2), q per px
/// along it. Depends on pixels and options alone; same bytes for any number of threads.
/// @throws InvalidArgument for options outside their domain, anchors outside the picture, fewer than 32 × 32 pixels;
/// UndefinedDataError for a picture of one grey level or without an edge.
[[nodiscard]] ContourTrace trace_contour(const FramePixels& pixels, const TraceOptions& options = {});

}  // namespace setae::imaging
