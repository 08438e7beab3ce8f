// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

#include "setae/core/quantity.hpp"
#include "setae/topography/tip.hpp"

namespace setae::spectral_fit {

/// A lamella in projection: at each x the highest point over its thickness along the beam.
struct Foil {
    double thickness = 0.0;  ///< [m], > 0
};

/// Probe of a measurement: a tip that touches the surface from above, or a beam through a foil.
struct Probe {
    std::variant<topography::Tip, Foil> shape;
    double size = 0.0;        ///< radius of the apex, or thickness [m], > 0
    double size_error = 0.0;  ///< its standard error [m]; 0 if unknown
    std::string name;         ///< such as "sphere, 10 nm"; distinguishes probes

    [[nodiscard]] bool is_foil() const { return std::holds_alternative<Foil>(shape); }
};

/// @throws InvalidArgument for sizes and angles outside the domains of the shapes, all of them.
[[nodiscard]] Probe sphere(const Estimate& radius);
[[nodiscard]] Probe paraboloid(const Estimate& radius);
/// half_angle [rad]; the radius of the end must be > 0 here, because no real tip is ideally sharp.
[[nodiscard]] Probe cone(const Estimate& radius, double half_angle);
/// The radius of the apex is topography::apex_radius().
[[nodiscard]] Probe measured_tip(topography::ArrayTip tip, const std::string& name);
[[nodiscard]] Probe foil(const Estimate& thickness);

/// The probe with another size; a measured tip is stretched along its axis to the radius.
[[nodiscard]] Probe with_size(const Probe& probe, double size);

/// Transfer function of an optical profiler for a wave with an amplitude far below the depth of focus.
///
///   T(q) = (2/π) (acos ν − ν √(1 − ν²)),  ν = q λ/(4π NA) <= 1;  0 beyond
///
/// Source: incoherent imaging through a round aperture, Goodman, Introduction to Fourier Optics, §6.3; for interference
/// microscopes de Groot, Appl. Sci. 11 (2021) 1554.
struct OpticalTransfer {
    double numerical_aperture = 0.0;  ///< NA > 0
    double light_wavelength = 0.0;    ///< λ, mean of the light [m], > 0

    [[nodiscard]] double cutoff() const;  ///< 4π NA/λ [1/m]
    [[nodiscard]] double at(double wavevector) const;
};

}  // namespace setae::spectral_fit
