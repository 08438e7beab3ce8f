// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/core/arrays.hpp"
#include "setae/half_space/body.hpp"
#include "setae/half_space/grid.hpp"

namespace setae::half_space {

/// Attraction of two surfaces across a gap g; they cannot penetrate each other, g >= 0.
///
///   V(0) = −w, V(∞) = 0, V'(0) = σ = w/ρ, the greatest tension, for all laws
///
///   exponential     V = −w exp(−g/ρ)
///   cubic           V = −w (1 − g/3ρ)³ for g < 3ρ, 0 beyond
///   dugdale         V = −w (1 − g/ρ) for g < ρ, 0 beyond: constant tension (Maugis)
///   lennard_jones   V = −w/(1 + g/2ρ)²: decreases like the attraction of half-spaces
enum class AttractionLaw { exponential, cubic, dugdale, lennard_jones };

/// @throws InvalidArgument that lists the names there are.
[[nodiscard]] AttractionLaw attraction_law_named(std::string_view name);
[[nodiscard]] std::string name_of(AttractionLaw law);

/// Attraction across a gap.
struct Interaction {
    double work_of_adhesion = 0.0;  ///< w [J/m²], > 0
    double range = 0.0;             ///< ρ [m], > 0
    AttractionLaw law = AttractionLaw::exponential;

    [[nodiscard]] double greatest_tension() const { return work_of_adhesion / range; }  ///< σ [Pa]
};

/// V [J/m²], V' [Pa] and V'' [Pa/m] of gaps, which are >= 0.
struct Attraction {
    double energy = 0.0, tension = 0.0, slope = 0.0;
};
[[nodiscard]] Attraction attraction(double gap, const Interaction& interaction);

/// Attraction for a row of gaps: returns Σ V, writes V' [Pa], and V'' in units of slope_unit [Pa/m].
double attraction(Index points, const double* gaps, const Interaction& interaction, double* tensions, float* slopes,
                  double slope_unit);

/// Resolution of an attraction by a grid: μ² = w dx/(E*ρ²), dx the longer side of a pixel along which a map has more
/// than one point.
///
/// A moving edge is trapped between pixels where μ² is large: the work to open exceeds that to close by 0.01 w at μ² =
/// 0.36, 0.05 at 0.64, 0.15 at 1 (exponential law, straight front in a cell of 256 pixels).
struct Resolution {
    double squared_ratio = 0.0;     ///< μ²
    double pixel_of_warning = 0.0;  ///< pixel size [m] with μ² = 1/2
    double pixel_of_refusal = 0.0;  ///< pixel size [m] with μ² = 1
};
[[nodiscard]] Resolution resolution_of(const Interaction& interaction, const Body& body, const Grid& grid);

/// @throws InvalidArgument for μ² > 1, with the required grid; for an interaction outside its domain.
void require(const Interaction& interaction, const Body& body, const Grid& grid);

}  // namespace setae::half_space
