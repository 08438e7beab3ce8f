// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/energy_ledger.hpp"
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

class Bookkeeper {
public:
    Bookkeeper(const LevelRecord& record, const std::optional<Estimate>& stiffness)
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
        LoopErrorBudget& budget = entry.standard_error;
        const double drift = std::isnan(budget.drift) ? 0.0 : budget.drift;
        budget.total =
            std::hypot(std::hypot(budget.noise, drift, budget.compliance), budget.sampling, budget.discretisation);
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
    EnergyBudget ledger{.contact = contact, .loop = loop_energy(loop, segments, contact, inputs.drift)};
    const ContactSegments& touch = segments.contacts[static_cast<std::size_t>(contact)];
    const LevelRecord record(loop, segments, inputs.drift);
    const Bookkeeper book(record, inputs.displacement_stiffness);

    const IndexRange range = closed_range(segments, contact);
    const Index first_contact = touch.jump_in ? touch.jump_in->last : touch.loading.first;
    const Index last_press = touch.unloading->first;
    IndexRange separation{touch.unloading->last, touch.unloading->last};
    if (touch.pull_off) separation = {largest_step(record.force, *touch.pull_off), touch.pull_off->last};
    ledger.before_contact = book.smooth({range.first, touch.jump_in ? touch.jump_in->first : first_contact});
    if (touch.jump_in) ledger.jump_in = book.jump(*touch.jump_in);
    ledger.approach = book.smooth({first_contact, last_press});
    ledger.retraction = book.smooth({last_press, separation.first});
    if (touch.pull_off) ledger.jump_out = book.jump(separation);
    ledger.after_contact = book.smooth({separation.last, range.last});
    ledger.recovered_share = -ledger.retraction.energy / ledger.approach.energy;

    ledger.machine_stiffness = inputs.machine_stiffness;
    if (inputs.smooth_sphere.work_of_adhesion > 0.0) {
        ledger.ideal_fixed_grips = contact::jkr::ideal_loop_loss(inputs.smooth_sphere).total;
        ledger.ideal_this_machine = spring_jumps(inputs.smooth_sphere, inputs.machine_stiffness).total();
    }
    ledger.largest_contact_area = inputs.largest_contact_area;
    ledger.true_area_ratio = inputs.true_area_ratio;
    ledger.loss_per_apparent_area = ledger.loop.energy / ledger.largest_contact_area;
    ledger.loss_per_true_area = ledger.loop.energy / ledger.largest_true_area();
    return ledger;
}

}  // namespace setae::loops
