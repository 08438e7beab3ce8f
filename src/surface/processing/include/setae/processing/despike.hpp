// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"
#include "setae/topography/mask.hpp"

namespace setae::processing {

/// Options of find_spikes.
struct SpikeOptions {
    double threshold = 6.0;  ///< in robust standard deviations, > 0
    Index reach = 2;         ///< points on each side of a point in its surroundings, 1 … 10
};

/// Points that deviate from their surroundings.
struct Spikes {
    topography::Mask mask;  ///< 1 = spike; shape (nx, ny), for lines (n, 1)
    Index count = 0;
    double deviation = 0.0;  ///< robust standard deviation s of the differences r [m]; 0 if all surroundings agree
    double threshold = 0.0;  ///< |r| above which a point is a spike [m]: options.threshold · s
};

/// Points whose height differs from the median of their surroundings by more than expected from the rest of the
/// surface.
///
///   r = h − median of the defined neighbours,   s = 1.4826 · median |r|,   spike: |r| > threshold · s
///
/// Neighbours: the square (for lines: the interval) of 2 reach + 1 points without its centre, after subtraction of the
/// median tilt of the map; at borders it is narrowed equally on both sides, so a slope gives no difference. The corners
/// of a map and the ends of a line have no surroundings and are never spikes. Points are tested in order of decreasing
/// |r|; a smaller one is a spike only if it exceeds the threshold without the spikes found around it. If more than half
/// of the r vanish (digitised heights), s is the quantile of |r| at 0.9, otherwise 0.99, over that of a normal
/// distribution. A point is the edge of a step and no spike if a third of its neighbours are at its height to within
/// |r|/2. Undefined points are never spikes.
/// @throws InvalidArgument for options outside their domain; UndefinedDataError if no point is defined.
/// Source: Hampel, J. Am. Stat. Assoc. 69 (1974) 383 (median, MAD); Tukey, Exploratory Data Analysis (1977) (running
/// medians). Cost: linear in points times (2 reach + 1)², two passes more for the tilt; memory: the mask, and copies of
/// about a twentieth of the heights.
[[nodiscard]] Spikes find_spikes(const topography::HeightMap& map, const SpikeOptions& options = {},
                                 parallel::Threads threads = {});
[[nodiscard]] Spikes find_spikes(const topography::LineScan& scan, const SpikeOptions& options = {},
                                 parallel::Threads threads = {});

/// Replacement of a spike.
enum class SpikeReplacement {
    undefined,     ///< the point becomes undefined
    local_median,  ///< the median of the surroundings without spikes
};
inline constexpr std::array<Choice<SpikeReplacement>, 2> spike_replacement_names{
    {{"undefined", SpikeReplacement::undefined}, {"local_median", SpikeReplacement::local_median}}};

/// Removes spikes found by find_spikes(); the record contains their number, the threshold, and Sq (lines: Rq) before
/// and after.
struct Despike {
    double threshold = 6.0;
    Index reach = 2;
    SpikeReplacement replace_by = SpikeReplacement::local_median;
};

inline constexpr std::string_view step_name(const Despike&) { return "despike"; }
template <class Visitor>
void visit_parameters(Despike& step, Visitor& visitor) {
    visitor.number("threshold", step.threshold,
                   "difference to the local median that makes a spike, in robust standard deviations");
    visitor.count("reach", step.reach, "points on each side that the local median is of");
    visitor.choice("replace_by", step.replace_by, spike_replacement_names, "what takes the place of a spike");
}

/// A point in storage order and a height for it [m].
struct NewHeight {
    Index point;
    double height;
};

/// The replacement of each spike, in storage order; NaN if all points around it are undefined or spikes.
[[nodiscard]] std::vector<NewHeight> heights_without(const Spikes& spikes, const Despike& step,
                                                     const topography::HeightMap& map);
[[nodiscard]] std::vector<NewHeight> heights_without(const Spikes& spikes, const Despike& step,
                                                     const topography::LineScan& scan);

/// @throws InvalidArgument as find_spikes(), and for polylines, whose points have no equal steps (resample first).
[[nodiscard]] Processed apply(const Despike& step, topography::Measurement measurement, parallel::Threads threads = {});

}  // namespace setae::processing
