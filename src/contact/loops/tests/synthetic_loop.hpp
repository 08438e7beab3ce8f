// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/loops/loop.hpp"

namespace setae::loops::tests {

/// A smooth lens under fixed grips whose W on retraction may exceed that on approach: results of the closed forms
/// is known exactly.
struct SyntheticLoop {
    contact::jkr::Contact approach{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};
    double retraction_work = 0.040;
    double largest_radius = 1.2e-4;  ///< at the largest load [m]
    int samples = 400;               ///< of each branch, and of free flight before and after
    bool even_in_displacement = false;

    [[nodiscard]] contact::jkr::Contact retraction() const {
        return {approach.radius, approach.contact_modulus, retraction_work};
    }

    /// 3/5 πW a0² in the jump, (W_r − W_a) π a_max² on retraction, 2/5 πW_r a_c² at pull-off.
    [[nodiscard]] double loss() const {
        const double a_in = contact::jkr::jump_in_at_fixed_grips(approach).contact_radius;
        const double a_out = contact::jkr::pull_off_at_fixed_grips(retraction()).contact_radius;
        return pi * (0.6 * approach.work_of_adhesion * a_in * a_in +
                     (retraction_work - approach.work_of_adhesion) * largest_radius * largest_radius +
                     0.4 * retraction_work * a_out * a_out);
    }

    /// Force, displacement and contact radius, jumps sampled at both ends.
    [[nodiscard]] Loop make() const;
};

namespace detail {

struct Series {
    std::vector<double> force, displacement, radius;

    void add(double f, double d, double a) {
        force.push_back(f);
        displacement.push_back(d);
        radius.push_back(a);
    }
    static Array1D array(const std::vector<double>& values) {
        return Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
    }
};

/// Equilibrium from one contact radius to another, even steps in radius or in displacement.
inline void add_branch(Series& series, const contact::jkr::Contact& lens, double from, double to, int steps,
                       bool even_in_displacement) {
    using namespace contact::jkr;
    const double d_from = displacement(from, lens), d_to = displacement(to, lens);
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        double a = from + share * (to - from);
        if (even_in_displacement && i > 0 && i < steps)
            a = contact_radius_at_displacement(d_from + share * (d_to - d_from), lens);
        series.add(force(a, lens), displacement(a, lens), a);
    }
}

inline void add_free_flight(Series& series, double from, double to, int steps) {
    for (int i = 0; i <= steps; ++i) series.add(0.0, from + (to - from) * i / steps, 0.0);
}

}  // namespace detail

inline Loop SyntheticLoop::make() const {
    using namespace contact::jkr;
    detail::Series series;
    const double far = 3.0 * pull_off_at_fixed_grips(retraction()).displacement;
    detail::add_free_flight(series, far, 0.0, samples);
    detail::add_branch(series, approach, jump_in_at_fixed_grips(approach).contact_radius, largest_radius, samples,
                       even_in_displacement);
    // the edge stays pinned while G rises from one W to the other; force is linear in displacement
    if (retraction_work > approach.work_of_adhesion) {
        const double high = series.displacement.back(), low = displacement(largest_radius, retraction());
        for (int i = 1; i < samples; ++i) {
            const double d = high + (low - high) * i / samples;
            series.add(force_at(largest_radius, d, {approach.radius, approach.contact_modulus}), d, largest_radius);
        }
    }
    const State separation = pull_off_at_fixed_grips(retraction());
    detail::add_branch(series, retraction(), largest_radius, separation.contact_radius, samples, even_in_displacement);
    detail::add_free_flight(series, separation.displacement, far, samples);
    const Index n = static_cast<Index>(series.force.size());
    return {.time = Array1D::LinSpaced(n, 0.0, 0.1 * static_cast<double>(n - 1)),
            .force = detail::Series::array(series.force),
            .displacement = detail::Series::array(series.displacement),
            .contact_radius = detail::Series::array(series.radius)};
}

inline LensAndCounterBody rubber_on_diamond(double radius = 1.25e-3) {
    return {.radius = radius, .counter_youngs_modulus = 1100e9, .counter_poisson_ratio = 0.06};
}

/// So many samples of every series, from the first given.
inline Loop piece(const Loop& loop, Index first, Index count) {
    const auto part = [&](const Array1D& series) -> Array1D {
        return series.size() == 0 ? series : Array1D(series.segment(first, count));
    };
    return {.time = part(loop.time),
            .force = part(loop.force),
            .displacement = part(loop.displacement),
            .contact_radius = part(loop.contact_radius)};
}

inline Loop from(const Loop& loop, Index first) { return piece(loop, first, loop.force.size() - first); }

/// The series with independent normal noise of standard deviation sigma.
inline Array1D with_noise(const Array1D& series, double sigma, std::mt19937_64& generator) {
    std::normal_distribution<double> normal(0.0, sigma);
    Array1D noisy = series;
    for (double& value : noisy) value += normal(generator);
    return noisy;
}

}  // namespace setae::loops::tests
