// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "setae/imaging/contact_frame.hpp"

namespace setae::imaging {

/// An ellipse [px] in the parameters that are linear for small eccentricity:
///   semi-axes mean_radius ± stretch, stretch = sqrt(stretch_cosine² + stretch_sine²), angle ½ atan2(stretch_sine,
///   stretch_cosine).
struct Outline {
    double centre_x = 0, centre_y = 0, mean_radius = 0, stretch_cosine = 0, stretch_sine = 0;

    [[nodiscard]] double stretch() const;
    [[nodiscard]] double semi_major() const { return mean_radius + stretch(); }
    [[nodiscard]] double semi_minor() const { return mean_radius - stretch(); }
    [[nodiscard]] double angle() const;
    /// Distance from the centre at a polar angle [rad].
    [[nodiscard]] double radius_at(double polar_angle) const;
};

/// Signed distances from an outline, positive outside; first order in the distance over the radius, exact for circles.
class OutlineDistance {
public:
    explicit OutlineDistance(const Outline& outline);
    [[nodiscard]] double operator()(double x, double y) const;

private:
    double centre_x_, centre_y_, cosine_, sine_, inverse_major_, inverse_minor_;
};

/// Distance of an edge from an outline.
struct EdgeOffset {
    double angle = 0;     ///< polar [rad]
    double offset = 0;    ///< along the normal [px]
    double variance = 1;  ///< expected from pixel noise [px²]
};

enum class OutlineShape { circle, ellipse };

/// Correction of an outline by offsets from it.
struct OutlineCorrection {
    Outline outline;
    std::vector<double> weights;             ///< of Tukey's biweight; 0 if the offset does not agree
    Eigen::Matrix<double, 5, 5> covariance;  ///< of centre_x, centre_y, mean_radius, stretch_cosine, stretch_sine [px²]
    double largest_step = 0;                 ///< [px]
    double scale = 0;                        ///< robust standard deviation of an offset over its expected one
    bool solved = false;                     ///< false: too few offsets around the outline
};

/// One Gauss–Newton step with iteratively reweighted least squares (Tukey's biweight at 4.685, scale by the median).
///
/// The covariance follows from the scatter of offsets, at least that expected from pixel noise, times (1 + ρ)/(1 − ρ)
/// of the correlation ρ of neighbouring offsets, at least 1. Offsets are in order of angle. A circle has no stretch.
[[nodiscard]] OutlineCorrection corrected_outline(const Outline& outline, const std::vector<EdgeOffset>& offsets,
                                                  OutlineShape shape);

/// Circle through points, by random sample consensus (triples of a fixed sequence), then offsets as in
/// corrected_outline.
struct EdgePoint {
    double x = 0, y = 0;
};
[[nodiscard]] Outline consensus_circle(const std::vector<EdgePoint>& points, double tolerance,
                                       const Outline& otherwise);

}  // namespace setae::imaging
