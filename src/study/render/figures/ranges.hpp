// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/figures/figure.hpp"

namespace setae::figures {

/// Ends of a drawn axis, from < to.
struct Range {
    double from = 0.0, to = 1.0;
};

/// @throws InvalidArgument that names the panel where its arrays differ in length.
void require_drawable(const Panel& panel);

/// Whether an axis can show a number: finite, and positive where it is logarithmic.
[[nodiscard]] bool shows(const Axis& axis, double value);

/// The stated ends of an axis, else those of the panel's data within its domain with a margin.
/// @throws InvalidArgument for ends that are not finite, not in order, or not positive on a logarithmic axis.
[[nodiscard]] Range x_range(const Panel& panel);
[[nodiscard]] Range y_range(const Panel& panel);

/// The values at the ends of a map's colours: those it states, else those it holds.
[[nodiscard]] Range value_range(const HeatMap& map);

/// Position of a value along an axis: 0 at from, 1 at to.
[[nodiscard]] double share(const Axis& axis, const Range& range, double value);

/// A band with points added where it leaves the panel and its ends limited to the inside: gnuplot fills clipped bands
/// wrongly.
[[nodiscard]] Series clipped_band(const Panel& panel, const Series& band, const Range& x, const Range& y);

/// The corner in which a box of width and height (shares of the panel) hides the least data.
[[nodiscard]] Corner emptiest_corner(const Panel& panel, const Range& x, const Range& y, double width, double height);

}  // namespace setae::figures
