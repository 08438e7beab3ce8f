// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/probe.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::spectral_fit {
namespace {

/// 0 if unknown.
double known_error(const Estimate& size) { return size.standard_error > 0.0 ? size.standard_error : 0.0; }

Probe tip(topography::Tip shape, const Estimate& radius, const std::string& kind) {
    if (!(radius.value > 0.0)) throw InvalidArgument(fmt::format("a tip of {} m; expected > 0", radius.value));
    topography::validate(shape);
    return {std::move(shape), radius.value, known_error(radius),
            fmt::format("{}, {:.6g} nm", kind, radius.value * 1e9)};
}

}  // namespace

Probe sphere(const Estimate& radius) { return tip(topography::SphereTip{radius.value}, radius, "sphere"); }

Probe paraboloid(const Estimate& radius) { return tip(topography::ParabolicTip{radius.value}, radius, "paraboloid"); }

Probe cone(const Estimate& radius, double half_angle) {
    return tip(topography::ConeTip{half_angle, radius.value}, radius,
               fmt::format("cone of {:.6g} degrees", half_angle * 180.0 / pi));
}

Probe measured_tip(topography::ArrayTip shape, const std::string& name) {
    topography::validate(shape);
    const double radius = topography::apex_radius(shape);
    if (!(radius > 0.0))
        throw InvalidArgument(name + ": the tip is flat around its apex; expected pixels that resolve its curvature");
    return {topography::Tip(std::move(shape)), radius, 0.0, name};
}

Probe foil(const Estimate& thickness) {
    if (!(thickness.value > 0.0))
        throw InvalidArgument(fmt::format("a foil {} m thick; expected > 0", thickness.value));
    return {Foil{thickness.value}, thickness.value, known_error(thickness),
            fmt::format("foil, {:.6g} nm", thickness.value * 1e9)};
}

Probe with_size(const Probe& probe, double size) {
    Probe other = probe;
    other.size = size;
    if (auto* lamella = std::get_if<Foil>(&other.shape)) {
        lamella->thickness = size;
        return other;
    }
    auto& shape = std::get<topography::Tip>(other.shape);
    if (auto* array = std::get_if<topography::ArrayTip>(&shape)) array->heights *= probe.size / size;
    else if (auto* ball = std::get_if<topography::SphereTip>(&shape)) ball->radius = size;
    else if (auto* blunt = std::get_if<topography::ConeTip>(&shape)) blunt->radius = size;
    else std::get<topography::ParabolicTip>(shape).radius = size;
    return other;
}

double OpticalTransfer::cutoff() const { return 4.0 * pi * numerical_aperture / light_wavelength; }

double OpticalTransfer::at(double wavevector) const {
    const double share = wavevector / cutoff();
    if (share >= 1.0) return 0.0;
    return 2.0 / pi * (std::acos(share) - share * std::sqrt(1.0 - share * share));
}

}  // namespace setae::spectral_fit
