// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "setae/contact/jkr.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::tests {

constexpr double contact_point = 3.7e-6;

enum class BranchShape {
    loading,    ///< from the jump-in under fixed grips to 1 mN
    unloading,  ///< from 1 mN to the pull-off of a dead load, where δ(F) is vertical
};

/// A branch in equilibrium, samples even in displacement, without noise.
inline BranchData branch_of(const contact::jkr::Contact& lens, BranchShape shape, Index samples) {
    using namespace contact::jkr;
    const double top = displacement_at_force(1e-3, lens);
    const double separation = displacement(pull_off_at_fixed_load(lens).contact_radius, lens);
    const bool loading = shape == BranchShape::loading;
    const Array1D depth = Array1D::LinSpaced(samples, loading ? 0.0 : top, loading ? top : separation);
    BranchData data;
    data.contact_radius = contact_radius_at_displacement(depth, lens);
    data.force = data.contact_radius.unaryExpr([&](double a) { return force(a, lens); });
    data.displacement = depth + contact_point;
    return data;
}

/// With noise in all channels. The signal: the ranges of force and displacement, the largest contact radius.
inline BranchData noisy(BranchData data, double signal_to_noise, std::mt19937_64& generator) {
    data.force_noise = (data.force.maxCoeff() - data.force.minCoeff()) / signal_to_noise;
    data.displacement_noise = (data.displacement.maxCoeff() - data.displacement.minCoeff()) / signal_to_noise;
    data.contact_radius_noise = data.contact_radius.maxCoeff() / signal_to_noise;
    data.force = with_noise(data.force, data.force_noise, generator);
    data.displacement = with_noise(data.displacement, data.displacement_noise, generator);
    data.contact_radius = with_noise(data.contact_radius, data.contact_radius_noise, generator);
    return data;
}

/// The samples whose radius noise left positive, as a selection of samples in contact.
inline BranchData in_contact(const BranchData& data) {
    BranchData kept = data;
    Index n = 0;
    for (Index i = 0; i < data.force.size(); ++i) {
        if (!(data.contact_radius[i] > 0.0)) continue;
        kept.force[n] = data.force[i];
        kept.displacement[n] = data.displacement[i];
        kept.contact_radius[n++] = data.contact_radius[i];
    }
    for (Array1D* series : {&kept.force, &kept.displacement, &kept.contact_radius}) series->conservativeResize(n);
    return kept;
}

/// Whether the 95 % interval covers the true value.
inline bool covers(const Estimate& estimate, double truth) {
    const auto interval = interval_of(estimate);
    return interval && interval->lower < truth && truth < interval->upper;
}

}  // namespace setae::loops::tests
