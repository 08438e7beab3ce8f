// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    std::vector<std::vector<Anchor>> anchors;  ///< one list a segment, in order along it; empty: found without help
    std::vector<Region> hidden;                ///< parts that show no sample, such as scale bars
    std::optional<double> smoothing_length;    ///< of the spline; unset: least expected error
    double least_length = 50.0;                ///< shorter segments are left out
};

/// One stretch of the boundary, vacuum on the left hand of who walks along it as the picture is seen: above a curve that runs to
/// the right.
struct ContourSegment {
    Array1D x, y;              ///< [px]; about one point a pixel of length
    Array1D standard_error;    ///< of each place along the normal [px]; 0 where the picture has two grey levels alone
    bool closed = false;       ///< an outline: the last point is joined to the first
    double length = 0;         ///< [px]
    std::vector<std::size_t> anchors;  ///< points that are anchors
};

/// What a picture gave.
struct ContourTrace {
    std::vector<ContourSegment> segments;  ///< longest first
    Vacuum vacuum = Vacuum::automatic;     ///< as found
    bool binary = false;           ///< two grey levels: outlines run along the borders of pixels, exactly
    double vacuum_level = 0, vacuum_noise = 0;  ///< robust mean and standard deviation of a pixel
    double sample_level = 0, sample_noise = 0;  ///< the latter with the sample's own structure
    double contrast_to_noise = 0;  ///< |sample − vacuum| over the vacuum's noise
    double edge_width = 0;         ///< standard deviation of the blur across the edge [px]
    double smoothing_length = 0;   ///< of the spline along the contour [px]
    double noise_density = 0;      ///< of places along the normal before smoothing: variance of one point times its spacing [px³]
    bool fringe = false;           ///< a Fresnel fringe stands out
    std::vector<Alert> alerts;     ///< TWO_EDGES, VACUUM_ASSUMED, LOW_CONTRAST, NOT_CONVERGED, SPIKES …
};

/// Traces the boundary between vacuum and sample. Depends on pixels and options alone; same bytes for any number of threads.
/// @throws InvalidArgument for options outside their domain; UndefinedDataError for a picture of one grey level or without an edge.
[[nodiscard]] ContourTrace trace_contour(const FramePixels& pixels, const TraceOptions& options = {});

}  // namespace setae::imaging
