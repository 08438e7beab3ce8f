// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "setae/core/arrays.hpp"

namespace setae::spectral_fit {

/// ln C_iso as a cubic B-spline in ln q with ten coefficients per decade, the last knot at q_s.
///
/// Between `lowest` and q_s = `shortest`; constant below, C_iso = 0 above q_s.
class LogSpline {
public:
    /// lowest < shortest [1/m]. @throws InvalidArgument otherwise.
    LogSpline(double lowest, double shortest);

    [[nodiscard]] Index coefficients() const { return coefficients_; }
    [[nodiscard]] double shortest() const { return shortest_; }
    [[nodiscard]] double spacing() const { return spacing_; }  ///< of knots in ln q
    /// ln q of a coefficient.
    [[nodiscard]] double position(Index coefficient) const;
    /// Values of the basis at wavevectors: ln C_iso = design · coefficients. Shape (wavevectors, coefficients).
    [[nodiscard]] Eigen::MatrixXd design(const ArrayView1D& wavevectors) const;
    /// C_iso itself.
    [[nodiscard]] double value(const Eigen::VectorXd& theta, double wavevector) const;

private:
    struct Piece {
        Index first;
        double weight[4];
    };
    [[nodiscard]] Piece piece(double wavevector) const;

    double shortest_, spacing_, origin_;
    Index intervals_, coefficients_;
};

}  // namespace setae::spectral_fit
