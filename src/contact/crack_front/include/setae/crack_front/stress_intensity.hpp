// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "setae/crack_front/work_field.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::crack_front {

/// Part of a map that acts on a front, and its position.
struct MapOnFront {
    double contact_modulus = 0.0;  ///< E* [Pa], > 0
    /// λ_s [m]: shorter waves are left out; the length of the process zone is the lower limit
    double shortest_wavelength = 0.0;
    std::array<double, 2> centre{};  ///< centre of the rays [m]; unused for parallels
};

/// Stress intensity at a front by the roughness of the area in full contact.
///
///   K_R(x) = −E*/√2 Σ_q √(|q_z| + i q_x) h_q exp(iq·x),   ⟨K_R²⟩ = 2E* U_el/A,  U_el/A = (E*/4) Σ |q||h_q|²
///
/// q_x along the direction of growth of the contact, q_z along the front. A peak has K_R < 0 ahead of it: the contact
/// is pinned there. Sources: Rice, J. Appl. Mech. 52 (1985) 571 (weight function); Sanner et al. 2024 as in
/// work_field.hpp.
struct StressIntensity {
    Array2D values;  ///< K_R [Pa √m], shape (lines, points.count)
    LinePoints points;
    double stored_energy = 0.0;        ///< U_el/A of the waves that are taken into account [J/m²]
    double mean_wavelength = 0.0;      ///< 2π Σ|h_q|²/Σ|q||h_q|²: λ weighted by U_el [m]
    double contact_modulus = 0.0;      ///< E* [Pa]
    double shortest_wavelength = 0.0;  ///< λ_s [m]
};

/// K_R on rays from the centre of a circular front. q is decomposed along each ray's own direction.
///
/// One transform per ray: its modes lie at arbitrary q·n, and are spread to a grid (error below 5e-6 of
/// the rms). O(rays (modes + radii log radii)). A map that is not periodic is used inside the largest circle about the
/// centre, minus its mean there, and fades to 0 beyond the last radius; the outside acts on the rim only.
/// Equal bytes for any number of threads.
/// @throws InvalidArgument for E*, λ_s <= 0, λ_s below two pixels, radii apart more than λ_s/4 or angles more than
/// λ_s/2 at the last radius, and a last radius beyond 0.9 of the extent of a map that is not periodic;
/// UndefinedDataError for undefined heights.
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
