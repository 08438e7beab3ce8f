// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/core/arrays.hpp"

namespace setae::crack_front {

/// Points along one line on which a front moves: x_k = first + k spacing.
struct LinePoints {
    Index count = 0;       ///< >= 2
    double first = 0.0;    ///< [m]
    double spacing = 0.0;  ///< [m], > 0

    [[nodiscard]] double at(Index k) const { return first + static_cast<double>(k) * spacing; }
    [[nodiscard]] double last() const { return at(count - 1); }
};

/// Work of adhesion on the lines of a front: w of line j at x_k. Lines are rays from the centre at the angles
/// 2πj/lines, x the radius; or parallels at z_j = j width/lines, x along them, and the field is then periodic along x
/// and z.
struct WorkField {
    Array2D works;  ///< w [J/m²], shape (lines, points.count)
    LinePoints points;
    double mean_work = 0.0;  ///< mean work W [J/m²] of the field, > 0; stiffness of the front

    [[nodiscard]] Index lines() const { return works.rows(); }
};

/// Conversion of K_R to a work of adhesion. At a front K_J + K_R = √(2E*W), so that K_J is given by
///
///   quadratic   w = (√(2E*W) − K_R)²/(2E*)       mean W + U_el/A
///   linear      w = W − √(2W/E*) K_R             mean W
///
/// The mean of the quadratic field increases by U_el/A, where full contact costs U_el/A: the front theory is of first
/// order only. Take differences of works from the linear field, and the mean from the energy balance.
/// Source: Sanner, Kumar, Dhinojwala, Jacobs, Pastewka, Sci. Adv. 10 (2024) eadl1277.
enum class EquivalentWork { linear, quadratic };

/// w of K_R [Pa √m] on the lines. @throws InvalidArgument for W or E* <= 0, shapes that differ.
[[nodiscard]] WorkField equivalent_work(const ArrayView2D& stress_intensities, const LinePoints& points,
                                        double mean_work, double contact_modulus,
                                        EquivalentWork equivalent = EquivalentWork::linear);

/// w of a function of radius [m] and angle [rad]. @throws InvalidArgument for works that are not finite.
[[nodiscard]] WorkField work_of(const std::function<double(double radius, double angle)>& work, Index angles,
                                const LinePoints& radii, double mean_work);

/// Refuses a field outside its domain: fewer than 2 lines or points, w that is not finite, W <= 0, points out of order.
/// @throws InvalidArgument.
void require(const WorkField& field);

}  // namespace setae::crack_front
