// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <vector>

#include "setae/contact/jkr.hpp"
#include "setae/core/table.hpp"

namespace setae::study::loop_files {

inline constexpr double sphere_radius = 1e-3;
inline constexpr double contact_modulus = 1e6;

/// One press and release: JKR with one work of adhesion in, with another out, free flight at both ends; fixed grips.
inline Table loop(double work_in, double work_out, double depth) {
    namespace jkr = contact::jkr;
    const jkr::Contact in{sphere_radius, contact_modulus, work_in}, out{sphere_radius, contact_modulus, work_out};
    const double gap = 5e-6, step = depth / 2000.0;
    std::vector<double> displacement, force, radius;
    const auto add = [&](double d, double a, double f) {
        displacement.push_back(d);
        radius.push_back(a);
        force.push_back(f);
    };
    for (double d = -gap; d < 0.0; d += step) add(d, 0.0, 0.0);
    for (double d = 0.0; d <= depth; d += step) {
        const double a = jkr::contact_radius_at_displacement(d, in, jkr::Branch::outer);
        add(d, a, jkr::force(a, in));
    }
    const double end = jkr::pull_off_at_fixed_grips(out).displacement;
    for (double d = depth; d > end; d -= step) {
        const double a = jkr::contact_radius_at_displacement(d, out, jkr::Branch::outer);
        add(d, a, jkr::force(a, out));
    }
    for (double d = end - step; d > end - gap; d -= step) add(d, 0.0, 0.0);
    const auto column = [](const std::vector<double>& v) -> Array1D {
        return Eigen::Map<const Array1D>(v.data(), static_cast<Index>(v.size()));
    };
    return {{{"time", "s", Array1D::LinSpaced(static_cast<Index>(force.size()), 0.0, 100.0)},
             {"force", "N", column(force)},
             {"displacement", "m", column(displacement)},
             {"contact_radius", "m", column(radius)}},
            {}};
}

/// The same with noise of 0.2 µN, 1 nm and 0.1 µm, by a seed.
inline Table noisy_loop(double work_in, double work_out, double depth, unsigned seed) {
    Table table = loop(work_in, work_out, depth);
    std::mt19937_64 generator(seed);
    const auto add = [&](Array1D& values, double sigma, bool in_contact) {
        std::normal_distribution<double> normal(0.0, sigma);
        for (double& value : values)
            if (!in_contact || value > 0.0) value += normal(generator);
    };
    add(table.columns[1].values, 2e-7, false);
    add(table.columns[2].values, 1e-9, false);
    add(table.columns[3].values, 1e-7, true);
    return table;
}

}  // namespace setae::study::loop_files
