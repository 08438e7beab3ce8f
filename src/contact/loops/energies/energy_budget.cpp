// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/energy_budget.hpp"
#include "setae/contact/jkr.hpp"

#include <cmath>

#include <fmt/format.h>

#include "records/jump.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/spring_jumps.hpp"
#include "work_integral.hpp"

namespace setae::loops {
namespace {

class WorkEntries {
public:
    WorkEntries(const LevelRecord& record, const std::optional<Estimate>& stiffness)
        : record_(record), stiffness_(stiffness) {}

    [[nodiscard]] WorkEntry smooth(const IndexRange& range) const {
        WorkEntry entry = counted(range);
        entry.standard_error.discretisation = std::abs(discretisation_error(record_, range));
        return with_total(entry);
    }
    [[nodiscard]] WorkEntry jump(const IndexRange& range) const {
        WorkEntry entry = counted(range);
        entry.standard_error.sampling = jump_error_limit(record_, range) / std::sqrt(3.0);
        return with_total(entry);
    }

private:
    [[nodiscard]] WorkEntry counted(const IndexRange& range) const {
        WorkEntry entry{.range = range, .energy = work(record_.force, record_.displacement, range)};
        entry.standard_error.noise = noise_error(record_, range);
        entry.standard_error.drift = drift_error(record_, range);
        if (stiffness_) entry.standard_error.compliance = compliance_error(record_, range, *stiffness_);
        return entry;
    }
    static WorkEntry with_total(WorkEntry entry) {
        LoopErrorBudget& errors = entry.standard_error;
        const double drift = std::isnan(errors.drift) ? 0.0 : errors.drift;
        errors.total =
            std::hypot(std::hypot(errors.noise, drift, errors.compliance), errors.sampling, errors.discretisation);
        return entry;
    }

    const LevelRecord& record_;
    const std::optional<Estimate>& stiffness_;
};

void require_valid(const EnergyBudgetInputs& inputs) {
    if (!(inputs.true_area_ratio >= 1.0))
        throw InvalidArgument(fmt::format("true area ratio must be >= 1, got {}", inputs.true_area_ratio));
    if (!(inputs.largest_contact_area > 0.0))
        throw InvalidArgument(fmt::format("largest contact area must be > 0 m2, got {}", inputs.largest_contact_area));
}

}  // namespace

EnergyBudget energy_budget(const Loop& loop, const Segments& segments, Index contact,
                           const EnergyBudgetInputs& inputs) {
    require_valid(inputs);
    EnergyBudget budget{.contact = contact, .loop = loop_energy(loop, segments, contact, inputs.drift)};
    const ContactSegments& touch = segments.contacts[static_cast<std::size_t>(contact)];
    const LevelRecord record(loop, segments, inputs.drift);
    const WorkEntries entries(record, inputs.displacement_stiffness);

    const IndexRange range = closed_range(segments, contact);
    const Index first_contact = touch.jump_in ? touch.jump_in->last : touch.loading.first;
    const Index last_press = touch.unloading->first;
    IndexRange separation{touch.unloading->last, touch.unloading->last};
    if (touch.pull_off) separation = {largest_step(record.force, *touch.pull_off), touch.pull_off->last};
    budget.before_contact = entries.smooth({range.first, touch.jump_in ? touch.jump_in->first : first_contact});
    if (touch.jump_in) budget.jump_in = entries.jump(*touch.jump_in);
    budget.approach = entries.smooth({first_contact, last_press});
    budget.retraction = entries.smooth({last_press, separation.first});
    if (touch.pull_off) budget.jump_out = entries.jump(separation);
    budget.after_contact = entries.smooth({separation.last, range.last});
    budget.recovered_share = -budget.retraction.energy / budget.approach.energy;

    budget.machine_stiffness = inputs.machine_stiffness;
    if (inputs.smooth_sphere.work_of_adhesion > 0.0) {
        budget.ideal_fixed_grips = contact::jkr::ideal_loop_loss(inputs.smooth_sphere).total;
        budget.ideal_this_machine = spring_jumps(inputs.smooth_sphere, inputs.machine_stiffness).total();
    }
    budget.largest_contact_area = inputs.largest_contact_area;
    budget.true_area_ratio = inputs.true_area_ratio;
    budget.loss_per_apparent_area = budget.loop.energy / budget.largest_contact_area;
    budget.loss_per_true_area = budget.loop.energy / budget.largest_true_area();
    return budget;
}

}  // namespace setae::loops
