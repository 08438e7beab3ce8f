// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectral_fit {

/// Stretched isotropy that keeps areas: features are s = exp λ times longer along φ0 than across.
///
///   C2D(q) = C(q m),  m² = cosh λ + sinh λ cos 2(φ − φ0),  φ the direction of q
///   lines along ψ are those of the isotropic C_ψ(q) = C(q/μ)/μ²,  μ² = cosh λ − sinh λ cos 2(ψ − φ0)
struct Stretch {
    Eigen::Vector2d vector = Eigen::Vector2d::Zero();  ///< λ (cos 2φ0, sin 2φ0)

    [[nodiscard]] double ratio() const;                      ///< s
    [[nodiscard]] double direction() const;                  ///< φ0, −π/2 … π/2 [rad]
    [[nodiscard]] double wave_square(double angle) const;    ///< m²
    [[nodiscard]] double length_square(double angle) const;  ///< μ²
};

/// A stretch that may change with the wavevector: between knots its vector is linear in ln q, beyond them constant.
class StretchLaw {
public:
    StretchLaw() = default;
    /// log_wavevector: increasing; a vector a knot.
    StretchLaw(std::vector<double> log_wavevector, std::vector<Eigen::Vector2d> vectors);

    [[nodiscard]] bool isotropic() const { return log_wavevector_.empty(); }
    [[nodiscard]] Stretch at(double wavevector) const;
    [[nodiscard]] Index knots() const { return static_cast<Index>(log_wavevector_.size()); }
    [[nodiscard]] double log_wavevector(Index knot) const { return log_wavevector_[static_cast<std::size_t>(knot)]; }
    /// Both components of all knots, one after the other.
    [[nodiscard]] Eigen::VectorXd values() const;
    [[nodiscard]] StretchLaw with(const Eigen::VectorXd& values) const;

private:
    std::vector<double> log_wavevector_;
    std::vector<Eigen::Vector2d> vectors_;
};

/// What a map shows of the stretch over half a decade.
struct ObservedStretch {
    double wavevector = 0.0;  ///< in the middle [1/m]
    Stretch stretch;
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();  ///< inverse covariance of its vector
};

/// Stretch of a map by the angles of its waves: maximum likelihood of its Hann-windowed C2D on annuli of a tenth of a
/// decade, E = A m^−p with A and the local exponent p of each annulus.
///
/// Waves from eight periods of the map's shorter side to half its Nyquist wavevector, below band.upper and where the
/// mean power is twenty times the least of any annulus. The five lowest wavevectors along the lines are left out, which
/// offsets and trends of lines leave their mark on. More scatter than exponential variates have widens the errors.
/// Empty for maps with undefined heights or without waves left.
/// Source: derived here; docs/concepts/likelihood.md.
[[nodiscard]] std::vector<ObservedStretch> observed_stretch(const topography::HeightMap& map, const Band& band,
                                                            parallel::Threads threads = {});

/// The stretch of a surface by its maps, and whether they show one.
struct StretchOfMaps {
    StretchLaw law;               ///< isotropic unless p < 0.01 and s > 1.05
    Eigen::MatrixXd information;  ///< of law.values()
    double constancy = 1.0;       ///< probability of differences between maps and scales as large by chance
};

/// One stretch for all scales where maps and scales agree (p > 0.001), else a knot each decade. Scatter beyond the
/// errors widens them.
[[nodiscard]] StretchOfMaps combined_stretch(const std::vector<ObservedStretch>& observed);

}  // namespace setae::spectral_fit
