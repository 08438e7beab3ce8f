// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/contact_line/contact_line.hpp"
#include "setae/core/estimate.hpp"

namespace setae::contact_line {

enum class Direction { advancing, receding };

/// Time at which the edge passed a position for the first time.
///
/// Between frames the edge moves at constant speed. Radii are divided into rings of one width; a cell is a ring at an
/// angle. Its speed is the width divided by the time in which the edge crossed it, so noise that moves back and forth
/// is counted once.
struct Passage {
    Direction direction = Direction::receding;
    Array1D ring;             ///< middles of R rings in the order in which they are passed [m]
    double width = 0.0;       ///< width of a ring [m]
    Array2D speed;            ///< (N, R) [m/s], > 0; NaN where the edge did not cross the whole cell
    double mean_speed = 0.0;  ///< distance divided by time of all crossings [m/s]
};

/// Rings from the smallest to the largest radius of the line.
/// ring_width: [m], > 0; 0: the median distance that the edge moves between frames, at least three times its noise.
/// @throws InvalidArgument as require_valid, for fewer than two frames, a negative width or more than 100 000 rings.
/// @throws UndefinedDataError where the edge crosses no ring in this direction.
[[nodiscard]] Passage passage(const ContactLine& line, Direction direction, double ring_width = 0.0);

/// Connected cells that are all fast, or all slow.
struct Cluster {
    Index cells = 0;
    double area = 0.0;    ///< [m²]
    double along = 0.0;   ///< extent along the line, arc [m]
    double across = 0.0;  ///< extent along the radius [m]
    double angle = 0.0;   ///< angle of the middle [rad]
    double radius = 0.0;  ///< radius of the middle [m]
};

enum class ClusterKind {
    jumps,    ///< speed > threshold · mean: sections that move at once
    arrests,  ///< speed < mean / threshold: sections that are arrested
};

/// Clusters in order of area, largest first; cells are neighbours across a side, the first angle next to the last.
/// @throws InvalidArgument for a threshold <= 1.
/// Source: Måløy, Santucci, Schmittbuhl, Toussaint, Phys. Rev. Lett. 96 (2006) 045501.
[[nodiscard]] std::vector<Cluster> clusters(const Passage& passage, ClusterKind kind, double threshold = 3.0);

/// Speeds of all cells divided by their mean.
[[nodiscard]] Array1D relative_speeds(const Passage& passage);

/// The tail of a distribution, p(x) ∝ x^−τ for x >= smallest.
struct PowerLawTail {
    Estimate exponent;      ///< τ, > 1
    double smallest = 0.0;  ///< smallest value of the tail
    Index count = 0;        ///< number of values in the tail
    double distance = 0.0;  ///< Kolmogorov distance of the values in the tail from the power law
};

/// τ = 1 + (n − 2)/Σ ln(x/smallest), n: count, the maximum of the likelihood, corrected for the bias if smallest is one
/// of the values, ± (τ − 1)/√(n − 3). smallest minimises the distance, among the values that leave at least `fewest`;
/// the standard error does not include that choice. values: numbers > 0, others are left out.
/// @throws UndefinedDataError where fewer than `fewest` values are left, or all are equal.
/// Source: Clauset, Shalizi, Newman, SIAM Rev. 51 (2009) 661.
[[nodiscard]] PowerLawTail power_law_tail(const ArrayView1D& values, Index fewest = 50);

}  // namespace setae::contact_line
