// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "setae/crack_front/work_field.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::crack_front {

/// What of a map counts, and where.
struct MapOnFront {
    double contact_modulus = 0.0;      ///< E* [Pa], > 0
    double shortest_wavelength = 0.0;  ///< λ_s [m]: shorter waves are left out, the process zone's length is the least
    std::array<double, 2> centre{};    ///< of the rays [m]; parallels: unused
};

/// Stress intensity at a front by the roughness behind which the contact is full.
///
///   K_R(x) = −E*/√2 Σ_q √(|q_z| + i q_x) h_q exp(iq·x),   ⟨K_R²⟩ = 2E* U_el/A,  U_el/A = (E*/4) Σ |q||h_q|²
///
/// q_x along the way the contact grows, q_z along the front. A peak has K_R < 0 ahead of it: there the contact stays.
/// Sources: Rice, J. Appl. Mech. 52 (1985) 571 (weight function); Sanner et al. 2024 as in work_field.hpp.
struct StressIntensity {
    Array2D values;  ///< K_R [Pa √m], shape (lines, points.count)
    LinePoints points;
    double stored_energy = 0.0;        ///< U_el/A of the waves that count [J/m²]
    double mean_wavelength = 0.0;      ///< 2π Σ|h_q|²/Σ|q||h_q|²: λ weighed by U_el [m]
    double contact_modulus = 0.0;      ///< E* [Pa]
    double shortest_wavelength = 0.0;  ///< λ_s [m]
};

/// K_R on rays from the centre of a circular front. q is split at each ray's own direction.
///
/// One transform a ray: its modes lie at q·n, anywhere, and are spread to a grid (error below 5e-6 of
/// the rms). O(rays (modes + radii log radii)). A map that is not periodic counts inside the largest circle about the
/// centre, less its mean there, and fades to 0 beyond the last radius; what is outside acts on the rim only.
/// Same bytes for any number of threads.
/// @throws InvalidArgument for E*, λ_s <= 0, λ_s below two pixels, radii apart more than λ_s/4 or angles more than
/// λ_s/2 at the last radius, and a last radius beyond 0.9 of where a map that is not periodic ends; UndefinedDataError
/// for undefined heights.
[[nodiscard]] StressIntensity stress_intensity_on_rays(const topography::HeightMap& map, const MapOnFront& options,
                                                       Index angles, const LinePoints& radii,
                                                       parallel::Threads threads = {});

/// K_R of a straight front that moves along x, at the points of a periodic map: line j is y_j.
/// @throws InvalidArgument for a map that is not periodic; otherwise as above.
[[nodiscard]] StressIntensity stress_intensity_on_parallels(const topography::HeightMap& map, const MapOnFront& options,
                                                            parallel::Threads threads = {});

/// A map of works of adhesion [J/m²], periodic, on rays; shorter waves than λ_s are left out.
/// @throws as stress_intensity_on_rays().
[[nodiscard]] WorkField works_on_rays(const topography::HeightMap& map, const MapOnFront& options, Index angles,
                                      const LinePoints& radii, parallel::Threads threads = {});

/// Radii 0 … largest, λ_s/16 apart, and the least even number of angles that are λ_s/8 apart at the largest.
struct RayGrid {
    Index angles = 0;
    LinePoints radii;
};
/// @throws InvalidArgument for lengths <= 0.
[[nodiscard]] RayGrid ray_grid(double largest_radius, double shortest_wavelength);

}  // namespace setae::crack_front
