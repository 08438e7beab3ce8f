// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/contact_line/contact_line.hpp"
#include "setae/core/estimate.hpp"

namespace setae::contact_line {

enum class Direction { advancing, receding };

/// When the edge passed a place for the first time.
///
/// Between frames it moves at constant speed. Radii are cut into rings of one width; a cell is a ring at an angle. Its
/// speed is the width over the time the edge took to cross it, so noise that goes back and forth counts once.
struct Passage {
    Direction direction = Direction::receding;
    Array1D ring;             ///< middles of R rings in the order they are passed [m]
    double width = 0.0;       ///< of a ring [m]
    Array2D speed;            ///< (N, R) [m/s], > 0; NaN where the edge did not cross the whole cell
    double mean_speed = 0.0;  ///< distance over time of all crossings [m/s]
};

/// Rings from the smallest to the largest radius of the line.
/// ring_width: [m], > 0; 0: the median distance that the edge moves between frames, at least three times its noise.
/// @throws InvalidArgument as require_valid, for fewer than two frames, a negative width or more than 100 000 rings.
/// @throws UndefinedDataError where the edge crosses no ring in this direction.
[[nodiscard]] Passage passage(const ContactLine& line, Direction direction, double ring_width = 0.0);

/// Cells that hang together and are all fast, or all slow.
struct Cluster {
    Index cells = 0;
    double area = 0.0;    ///< [m²]
    double along = 0.0;   ///< extent along the line, arc [m]
    double across = 0.0;  ///< extent along the radius [m]
    double angle = 0.0;   ///< of its middle [rad]
    double radius = 0.0;  ///< of its middle [m]
};

enum class ClusterKind {
    jumps,    ///< speed > threshold · mean: what lets go at once
    arrests,  ///< speed < mean / threshold: where the edge waits
};

/// Clusters in order of area, largest first; cells are neighbours across a side, the first angle beside the last.
/// @throws InvalidArgument for a threshold <= 1.
/// Source: Måløy, Santucci, Schmittbuhl, Toussaint, Phys. Rev. Lett. 96 (2006) 045501.
[[nodiscard]] std::vector<Cluster> clusters(const Passage& passage, ClusterKind kind, double threshold = 3.0);

/// Speeds of all cells over their mean.
[[nodiscard]] Array1D relative_speeds(const Passage& passage);

/// The tail of a distribution, p(x) ∝ x^−τ for x >= smallest.
struct PowerLawTail {
    Estimate exponent;      ///< τ, > 1
    double smallest = 0.0;  ///< where it begins
    Index count = 0;        ///< numbers in it
    double distance = 0.0;  ///< Kolmogorov's, of the numbers in it from the law
};

/// τ = 1 + (n − 2)/Σ ln(x/smallest), n: count, the likelihood's maximum without its bias where smallest is one of the
/// numbers, ± (τ − 1)/√(n − 3). smallest makes the distance least, among the numbers that leave at least `fewest`; the
/// ± does not know of that choice. values: numbers > 0, others are left out.
/// @throws UndefinedDataError where fewer than `fewest` numbers are left, or all are equal.
/// Source: Clauset, Shalizi, Newman, SIAM Rev. 51 (2009) 661.
[[nodiscard]] PowerLawTail power_law_tail(const ArrayView1D& values, Index fewest = 50);

}  // namespace setae::contact_line
