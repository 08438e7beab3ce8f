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

/// A stretch that can change with the wavevector: its vector is linear in ln q between knots, constant beyond them.
class StretchLaw {
public:
    StretchLaw() = default;
    /// log_wavevector: increasing; one vector per knot.
    StretchLaw(std::vector<double> log_wavevector, std::vector<Eigen::Vector2d> vectors);

    [[nodiscard]] bool isotropic() const { return log_wavevector_.empty(); }
    [[nodiscard]] Stretch at(double wavevector) const;
    [[nodiscard]] Index knots() const { return static_cast<Index>(log_wavevector_.size()); }
    [[nodiscard]] double log_wavevector(Index knot) const { return log_wavevector_[static_cast<std::size_t>(knot)]; }
    /// Both components of all knots, in sequence.
    [[nodiscard]] Eigen::VectorXd values() const;
    [[nodiscard]] StretchLaw with(const Eigen::VectorXd& values) const;

private:
    std::vector<double> log_wavevector_;
    std::vector<Eigen::Vector2d> vectors_;
};

/// Stretch of a map in half a decade.
struct ObservedStretch {
    double wavevector = 0.0;  ///< in the middle [1/m]
    Stretch stretch;
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();  ///< inverse covariance of its vector
};

/// Stretch of a map by the angles of its waves: maximum likelihood of its Hann-windowed C2D on annuli of a tenth of a
/// decade, E = A m^−p with A and the local exponent p of each annulus.
///
/// Waves from eight periods of the shorter side of the map to half its Nyquist wavevector, below band.upper and with
/// mean power above twenty times the smallest of any annulus. The five lowest wavevectors along the lines are left out,
/// because offsets and trends of lines affect them. Scatter above that of exponential variates increases the errors.
/// Empty for maps with undefined heights or without remaining waves.
/// Source: derived here; docs/concepts/likelihood.md.
[[nodiscard]] std::vector<ObservedStretch> observed_stretch(const topography::HeightMap& map, const Band& band,
                                                            parallel::Threads threads = {});

/// The stretch of a surface from its maps, and whether it is significant.
struct StretchOfMaps {
    StretchLaw law;               ///< isotropic unless p < 0.01 and s > 1.05
    Eigen::MatrixXd information;  ///< of law.values()
    double constancy = 1.0;       ///< probability of differences between maps and scales as large by chance
};

/// One stretch for all scales if maps and scales agree (p > 0.001), otherwise one knot per decade. Scatter beyond the
/// errors increases them.
[[nodiscard]] StretchOfMaps combined_stretch(const std::vector<ObservedStretch>& observed);

}  // namespace setae::spectral_fit
