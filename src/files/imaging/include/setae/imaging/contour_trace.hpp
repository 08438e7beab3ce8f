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

/// A point on the trace [px], coordinates as FramePixels.
struct Anchor {
    double x = 0, y = 0;
};

/// Options of the search for an edge. Lengths in pixels.
struct TraceOptions {
    Vacuum vacuum = Vacuum::automatic;
    /// One list per segment, in order along the segment. Two or more anchors: the segment runs from the first to the
    /// last along the strongest edge between them. One anchor: the nearest automatic segment is moved through it.
    /// Empty: automatic.
    std::vector<std::vector<Anchor>> anchors;
    std::vector<PictureRegion> hidden;  ///< parts without sample, such as scale bars; the trace crosses them smoothly
    std::optional<double> smoothing_length;  ///< ℓ of the spline (0: none); not given: minimum of the expected error
    double denoise = 0.0;                    ///< standard deviation of a Gaussian filter applied first
    std::optional<double> min_length;  ///< shorter segments are left out; not given: 50, for pictures with two grey
                                       ///< levels 0
};

/// One part of the boundary, with vacuum on the left in the direction of the points: above a curve that runs to the
/// right.
struct ContourSegment {
    Array1D x, y;                      ///< [px]; about one point per pixel of length; for a binary picture its corners
    Array1D standard_error;            ///< of each place along the normal [px]; 1/√12 for a binary picture
    bool closed = false;               ///< an outline: the last point is joined to the first
    double length = 0;                 ///< [px]
    std::vector<std::size_t> anchors;  ///< points that are anchors
    double edge_width = 0;             ///< w: standard deviation of the blur across the edge [px]
    double smoothing_length = 0;       ///< ℓ of the spline along the contour [px]
    double noise_density = 0;          ///< N: noise density of places before smoothing, the variance of a place times
                                       ///< the spacing, including the correlation of neighbours [px³]
    double contrast_to_noise = 0;  ///< step with slope and width of the edge, over the noise of a pixel on either side
    bool fringe = false;           ///< a Fresnel fringe is present
    bool converged = true;
};

/// Trace of a picture.
struct ContourTrace {
    std::vector<ContourSegment> segments;       ///< in the order of anchors, otherwise longest first
    Vacuum vacuum = Vacuum::automatic;          ///< as found
    bool binary = false;                        ///< two grey levels: outlines follow the borders of pixels exactly
    double vacuum_level = 0, vacuum_noise = 0;  ///< median and standard deviation of a pixel
    double sample_level = 0, sample_noise = 0;  ///< the latter including the structure of the sample
    std::vector<Alert> alerts;  ///< TWO_EDGES, VACUUM_ASSUMED, LOW_CONTRAST, NOT_CONVERGED, SPIKES, UNDEF
};

/// Traces the boundary between vacuum and sample.
///
///   segmentation → outline → repeated fit of the edge profile across it: two_phases.hpp, edge_refine.hpp
///
/// standard_error² = (1/π) ∫ [(1 − K)² S + K² N] dq: loss of edge structure (spectrum S) and remaining noise, K = 1/(1
/// + ℓ⁴ (2 − 2 cos q)²). Spectra of the trace are T² S + K² N, T = K exp(−q² w²/2), q per px along it. Depends only on
/// pixels and options; same bytes for any number of threads.
/// @throws InvalidArgument for options outside their domain, anchors outside the picture, fewer than 32 × 32 pixels;
/// UndefinedDataError for a picture of one grey level or without an edge.
[[nodiscard]] ContourTrace trace_contour(const FramePixels& pixels, const TraceOptions& options = {});

}  // namespace setae::imaging
