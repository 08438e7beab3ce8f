// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/pinning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::crack_front {

double larkin_length(double mean_wavelength, double energy_share) {
    if (!(mean_wavelength > 0.0 && energy_share > 0.0))
        throw InvalidArgument(fmt::format("a Larkin length of waves of {} m and U_el/(AW) = {}; expected both above 0",
                                          mean_wavelength, energy_share));
    return mean_wavelength / (4.0 * energy_share);
}

double mean_wavelength(double rms_height, double energy_per_modulus) {
    if (!(rms_height > 0.0 && energy_per_modulus > 0.0))
        throw InvalidArgument(
            fmt::format("mean wavelength of a surface of h_rms {} m and U_el/(AE*) {} m; expected both "
                        "above 0",
                        rms_height, energy_per_modulus));
    return 0.5 * pi * rms_height * rms_height / energy_per_modulus;
}

double free_length(double contact_radius, const contact::AdhesiveContact& contact) {
    if (!(contact_radius > 0.0 && contact.radius > 0.0 && contact.contact_modulus > 0.0 &&
          contact.work_of_adhesion > 0.0))
        throw InvalidArgument(
            fmt::format("edge of a contact of radius {} m; sphere R {} m, E* {} Pa, W {} J/m2; "
                        "expected all above 0",
                        contact_radius, contact.radius, contact.contact_modulus, contact.work_of_adhesion));
    const double opening = std::sqrt(2.0 * pi * contact_radius * contact.work_of_adhesion / contact.contact_modulus);
    const double restoring = 4.0 * contact_radius / (contact.radius * opening) - 1.0 / contact_radius;
    const double circumference = 2.0 * pi * contact_radius;
    return restoring * circumference > pi ? pi / restoring : circumference;
}

double larkin_lengths(double contact_radius, const contact::AdhesiveContact& contact, double mean_wavelength,
                      double energy_share) {
    return free_length(contact_radius, contact) / larkin_length(mean_wavelength, energy_share);
}

FrontValidity validity_of(const StressIntensity& intensity, double mean_work, double front_length,
                          double line_spacing) {
    if (!(mean_work > 0.0 && front_length > 0.0 && line_spacing > 0.0))
        throw InvalidArgument(fmt::format("a front of {} m with lines {} m apart and W = {} J/m2; expected all above 0",
                                          front_length, line_spacing, mean_work));
    FrontValidity found{.energy_share = intensity.stored_energy / mean_work, .front_length = front_length};
    found.work_scatter = 2.0 * std::sqrt(found.energy_share);
    found.larkin_length = larkin_length(intensity.mean_wavelength, found.energy_share);
    found.negative_share = 0.5 * std::erfc(1.0 / (found.work_scatter * std::numbers::sqrt2));
    found.points_per_wave = intensity.shortest_wavelength / std::max(intensity.points.spacing, line_spacing);
    constexpr double first_order = 1.0 / 16.0, conformal = 0.3, fine = 8.0;
    if (found.energy_share > conformal)
        found.cautions.push_back(
            fmt::format("U_el/(AW) = {:.2g} is above {}: the surfaces do not come into full contact spontaneously; use "
                        "the works of adhesive cells instead",
                        found.energy_share, conformal));
    else if (found.energy_share > first_order)
        found.cautions.push_back(
            fmt::format("std w/W = {:.2g}: {:.1g} of the field has w < 0, and first-order fronts overestimate its "
                        "scatter; expected U_el/(AW) up to {:.3g}, got {:.2g}",
                        found.work_scatter, found.negative_share, first_order, found.energy_share));
    if (front_length < found.larkin_length)
        found.cautions.push_back(
            fmt::format("a front of {:.3g} m is shorter than its Larkin length of {:.3g} m: it makes few jumps, and k "
                        "of long fronts does not apply",
                        front_length, found.larkin_length));
    if (found.points_per_wave < fine)
        found.cautions.push_back(fmt::format(
            "{:.2g} points per wavelength of {:.3g} m; expected {} or more: use a spacing of lines and "
            "points of {:.3g} m",
            found.points_per_wave, intensity.shortest_wavelength, fine, intensity.shortest_wavelength / fine));
    return found;
}

}  // namespace setae::crack_front
