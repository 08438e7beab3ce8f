// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Rows of quantities that several outputs have.

#include <array>

#include "setae/fields/describe.hpp"

namespace setae::output {

/// Rows of surface_quantities(): the last two only for maps with slopes.
inline constexpr std::array surface_quantity_rows{
    fields::possible("rms_height", "h_rms", "m", "rms height").with(fields::Missing::never),
    fields::possible("rms_slope", "h'_rms", "1", "rms slope").with(fields::Missing::never),
    fields::possible("rms_curvature", "h''_rms", "1/m", "rms curvature").with(fields::Missing::never),
    fields::possible("true_area_ratio", "A_true/A_app", "1", "true area over nominal area")
        .with(fields::Missing::never),
    fields::possible("true_area_ratio_small_slope", "1 + h'^2/2", "1", "true area over nominal area for small slopes")
        .with(fields::Missing::never),
    fields::possible("elastic_energy_per_modulus", "U_el/(A_app E*)", "m", "elastic energy per nominal area over E*")
        .with(fields::Missing::never),
    fields::possible("true_area_ratio_gaussian", "A_true/A_app", "1",
                     "true area over nominal area for Gaussian slopes"),
    fields::possible("true_area_ratio_measured_slopes", "A_true/A_app", "1",
                     "true area over nominal area for slopes distributed as those of the maps"),
};

/// Rows of loop_quantities().
inline constexpr std::array loop_quantity_rows{
    fields::possible("contact_radius", "a_max", "m", "contact radius at the preload"),
    fields::possible("energy_loss", "E_loss", "J", "loss of a reversible interface: a lower bound"),
    fields::possible("work_of_adhesion_retraction", "W_ret", "J/m2", "W_ret of a reversible interface: a lower bound"),
    fields::possible("pull_off_force", "F_po", "N", "pull-off force of a reversible interface: a lower bound"),
    fields::possible("smooth_sphere_pull_off_force", "F_po", "N", "pull-off force of a smooth sphere by JKR"),
    fields::possible("conformal_energy_loss", "E_loss", "J", "loss by the true-area balance (Eq. 10)"),
    fields::possible("conformal_work_of_adhesion_retraction", "W_ret", "J/m2",
                     "W_ret by the true-area balance (Eq. 10)"),
    fields::possible("conformal_pull_off_force", "F_po", "N", "pull-off force by the true-area balance (Eq. 10)"),
    fields::possible("conformal_smooth_sphere_pull_off_force", "F_po", "N",
                     "pull-off force of a smooth sphere by the true-area balance (Eq. 10)"),
};

}  // namespace setae::output
