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

/// What find_spikes compares with what.
struct SpikeOptions {
    double threshold = 6.0;  ///< in robust standard deviations, > 0
    Index reach = 2;         ///< points on each side of a point that its surroundings hold, 1 … 10
};

/// Points that stand out of their surroundings.
struct Spikes {
    topography::Mask mask;  ///< 1 = spike; shape (nx, ny), of lines (n, 1)
    Index count = 0;
    double deviation = 0.0;  ///< robust standard deviation s of the differences r [m]; 0 where surroundings agree
    double threshold = 0.0;  ///< |r| above which a point is a spike [m]: options.threshold · s
};

/// Points whose height differs from the median of their surroundings by more than the rest of the surface lets expect.
///
///   r = h − median of the defined neighbours,   s = 1.4826 · median |r|,   spike: |r| > threshold · s
///
/// Neighbours: the square (of lines: the stretch) of 2 reach + 1 points without its centre, the map's median tilt taken
/// off; at borders it is narrowed on both sides alike, so that a slope gives no difference. The corners of a map and
/// the ends of a line have no surroundings and are never spikes. The largest |r| come first; a smaller one counts only
/// if it stays above the threshold without the spikes found around it. Where more than half of the r vanish (digitised
/// heights), s is the quantile of |r| at 0.9, else 0.99, over that of a normal distribution. A point at whose own
/// height, to within |r|/2, a third of its neighbours lie is the edge of a step and no spike. Undefined points are none
/// either.
/// @throws InvalidArgument for options outside their domain; UndefinedDataError where no point is defined.
/// Source: Hampel, J. Am. Stat. Assoc. 69 (1974) 383 (median, MAD); Tukey, Exploratory Data Analysis (1977) (running
/// medians). Cost: linear in points times (2 reach + 1)², two passes more for the tilt; memory: the mask, and copies of
/// about a twentieth of the heights.
[[nodiscard]] Spikes find_spikes(const topography::HeightMap& map, const SpikeOptions& options = {},
                                 parallel::Threads threads = {});
[[nodiscard]] Spikes find_spikes(const topography::LineScan& scan, const SpikeOptions& options = {},
                                 parallel::Threads threads = {});

/// What takes the place of a spike.
enum class SpikeReplacement {
    undefined,     ///< nothing: the point becomes undefined
    local_median,  ///< the median of its surroundings that are no spikes
};
inline constexpr std::array<Choice<SpikeReplacement>, 2> spike_replacement_names{
    {{"undefined", SpikeReplacement::undefined}, {"local_median", SpikeReplacement::local_median}}};

/// Spikes as find_spikes() finds them are taken out; the record says how many, the threshold, and Sq (lines: Rq) before
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

/// What takes the place of each spike, in storage order; where no point around is defined and no spike, NaN.
[[nodiscard]] std::vector<NewHeight> heights_without(const Spikes& spikes, const Despike& step,
                                                     const topography::HeightMap& map);
[[nodiscard]] std::vector<NewHeight> heights_without(const Spikes& spikes, const Despike& step,
                                                     const topography::LineScan& scan);

/// @throws InvalidArgument as find_spikes() does, and for polylines, whose points have no equal steps: resample them
/// first.
[[nodiscard]] Processed apply(const Despike& step, topography::Measurement measurement, parallel::Threads threads = {});

}  // namespace setae::processing
