// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"
#include "setae/crack_front/front_loop.hpp"

namespace setae::crack_front {
namespace {

loops::BranchData branch_of(const std::vector<const FrontStep*>& steps) {
    const auto n = static_cast<Index>(steps.size());
    loops::BranchData data{.force = Array1D(n), .displacement = Array1D(n), .contact_radius = Array1D(n)};
    for (Index i = 0; i < n; ++i) {
        const auto& state = steps[static_cast<std::size_t>(i)]->state;
        data.force[i] = state.force;
        data.displacement[i] = state.displacement;
        data.contact_radius[i] = state.area_radius;
    }
    return data;
}

}  // namespace

BranchWorks branch_works(const FrontLoop& loop, const contact::SphereOnFlat& sphere) {
    std::vector<const FrontStep*> approach, back, moving;
    for (const auto& step : loop.steps) {
        if (!step.state.in_contact) continue;
        (step.approaching ? approach : back).push_back(&step);
    }
    for (const auto* step : back)
        if (step->min_retreat > 0.0) moving.push_back(step);
    constexpr std::size_t fewest = 4;
    if (approach.size() < fewest || moving.size() < fewest)
        throw UndefinedDataError(
            fmt::format("{} steps in contact on approach and {} on retraction with the whole edge in motion; expected "
                        "{} or more of both: use more steps, or press further",
                        approach.size(), moving.size(), fewest));
    const loops::LensAndCounterBody bodies{.radius = sphere.radius,
                                           .lens_poisson_ratio = 0.0,
                                           .counter_youngs_modulus = std::numeric_limits<double>::infinity()};
    BranchWorks works{.approach = loops::fit_radius_force(branch_of(approach), bodies), .retraction = {}};
    works.retraction = loops::fit_retraction(branch_of(moving), sphere.radius, works.approach.contact_modulus, 0.0);
    for (const auto* step : back) works.pull_off_force = std::min(works.pull_off_force, step->state.force);
    works.pull_off_work = contact::jkr::work_of_adhesion_from_pull_off(works.pull_off_force, sphere.radius);
    return works;
}

}  // namespace setae::crack_front
