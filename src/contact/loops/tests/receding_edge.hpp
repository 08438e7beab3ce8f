// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/loops/loop.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::tests {

/// A lens under fixed grips, loaded in equilibrium and released at constant speed, whose edge recedes as
/// G = G0 [1 + (v/v0)^n] asks. The equations are written out here, in displacement, by Runge and Kutta's method:
/// nothing is shared with the fit, which integrates in force by another rule.
struct RetractingLoop {
    contact::jkr::Contact loading{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};
    double threshold = 0.040, reference_speed = 1e-6, exponent = 0.6;
    double speed = 60e-9;         ///< of the grips [m/s]
    double largest_force = 1e-3;  ///< [N]
    double force_rate = 10.0;     ///< [1/s]
    Index frame_every = 5;        ///< samples
    double force_noise = 0.0, displacement_noise = 0.0, radius_noise = 0.0;

    [[nodiscard]] Loop make(unsigned seed = 0) const;

private:
    [[nodiscard]] double receding(double a, double depth) const {
        const double R = loading.radius, flat = a * a / R - depth;
        const double G = loading.contact_modulus * flat * flat / (2.0 * pi * a);
        return G > threshold ? reference_speed * std::pow(G / threshold - 1.0, 1.0 / exponent) : 0.0;
    }
};

inline Loop RetractingLoop::make(unsigned seed) const {
    std::vector<double> depths, radii;
    const double step = 1.0 / force_rate, top = contact::jkr::displacement_at_force(largest_force, loading);
    for (double depth = -1.5e-6; depth < top; depth += speed * step) {
        depths.push_back(depth);
        radii.push_back(depth < 0.0 ? 0.0 : contact::jkr::contact_radius_at_displacement(depth, loading));
    }
    constexpr int parts = 100;
    double a = contact::jkr::contact_radius_at_displacement(top, loading);
    const double gone = 0.08 * a;
    for (Index i = 0; a > gone; ++i) {
        const double depth = top - speed * step * static_cast<double>(i);
        depths.push_back(depth);
        radii.push_back(a);
        const double h = step / parts;
        for (int k = 0; k < parts && a > gone; ++k) {
            const double d0 = depth - speed * h * k, half = d0 - 0.5 * speed * h, d1 = d0 - speed * h;
            const double k1 = receding(a, d0), k2 = receding(a - 0.5 * h * k1, half),
                         k3 = receding(a - 0.5 * h * k2, half), k4 = receding(std::max(a - h * k3, gone), d1);
            a -= h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        }
    }
    for (int i = 0; i < 300; ++i) {
        depths.push_back(depths.back() - speed * step);
        radii.push_back(0.0);
    }
    const auto n = static_cast<Index>(depths.size());
    std::mt19937_64 generator(seed);
    Loop loop{.displacement = Eigen::Map<const Array1D>(depths.data(), n),
              .contact_radius = Eigen::Map<const Array1D>(radii.data(), n)};
    loop.time = step * Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1));
    const Array1D& r = loop.contact_radius;
    loop.force = 2.0 * loading.contact_modulus * (r * loop.displacement - r.cube() / (3.0 * loading.radius));
    loop.force = with_noise(loop.force, force_noise, generator);
    loop.displacement = with_noise(loop.displacement, displacement_noise, generator);
    const Array1D seen = with_noise(r, radius_noise, generator);
    for (Index i = 0; i < n; ++i)
        loop.contact_radius[i] = i % frame_every != 0 ? undefined : r[i] > 0.0 ? std::max(seen[i], 0.0) : 0.0;
    return loop;
}

}  // namespace setae::loops::tests
