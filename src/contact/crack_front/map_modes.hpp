// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/crack_front/stress_intensity.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"

namespace setae::crack_front {

/// Waves of a map in one half of the plane of wavevectors (q_y > 0, or q_y = 0 and q_x > 0), that of the map's mean
/// left out: h(x) = mean + 2 Re Σ c exp(iq·x), x counted from the centre.
struct MapModes {
    std::vector<double> qx, qy, real, imaginary;
    double mean = 0.0;
    double seen = 1.0;  ///< mean square of the window of the map: power of its waves divided by that of the surface

    [[nodiscard]] std::size_t count() const { return qx.size(); }
};

/// Modes of wavelengths >= λ_s. A map that is not periodic is faded out beyond `largest_radius`.
[[nodiscard]] MapModes modes_of(const topography::HeightMap& map, const MapOnFront& options, double largest_radius,
                                parallel::Threads threads);

/// U_el/A = (E*/4) Σ|q||h_q|² [J/m²] and 2π Σ|h_q|²/Σ|q||h_q|² [m] of all modes; of a map that was faded out, of the
/// surface that it shows.
struct ModeEnergy {
    double stored_energy = 0.0, mean_wavelength = 0.0;
};
[[nodiscard]] ModeEnergy energy_of(const MapModes& modes, double contact_modulus);

/// Sums 2 Re Σ f c exp(i r q·n) along rays n = (cos θ, sin θ) at evenly spaced radii.
class RaySums {
public:
    /// f = √(|q_z| + i q_x), or 1.
    enum class Factor { front, none };
    RaySums(const MapModes& modes, Factor factor, const LinePoints& radii);

    /// Values of one ray, 0 <= angle < π, and of the opposite one. Thread-safe.
    void along(double angle, double* values, double* opposite) const;

private:
    void transformed(fourier::Buffer<fourier::Complex>& grid, double* values) const;

    const MapModes& modes_;
    Factor factor_;
    LinePoints radii_;
    fourier::InverseRealTransform back_;
    double step_;                     ///< step of the transform's wavevectors
    std::vector<double> correction_;  ///< correction for the kernel, at each radius
    /// c √q exp(∓iφ/2), φ in [0, π): f c is one of them except for a phase that depends only on the ray
    std::vector<fourier::Complex> minus_, plus_;
};

}  // namespace setae::crack_front
