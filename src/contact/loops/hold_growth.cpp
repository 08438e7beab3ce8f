// SPDX-License-Identifier: GPL-3.0-or-later
#include "hold_growth.hpp"

#include <algorithm>

#include "branch.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/sample_mean.hpp"

namespace setae::loops {
namespace {

Change change_of(const Array1D& values, Index ends) {
    return {sample_mean(values.head(ends), "scatter of the first samples"),
            sample_mean(values.tail(ends), "scatter of the last samples")};
}

}  // namespace

std::optional<HoldGrowth> hold_growth(const LevelledLoop& record, const ContactSegments& contact,
                                      const BranchAnalysis& loading, const LensAndCounterBody& bodies,
                                      const AnalysisOptions& options) {
    if (!contact.hold) return std::nullopt;
    const BranchData data = branch_data(record, range_selection(*contact.hold, "hold"), options);
    constexpr Index fewest = 6;
    const Index n = data.force.size();
    if (n < fewest) return std::nullopt;
    const Index ends = std::max<Index>(n / 10, 3);
    HoldGrowth growth{.samples = *contact.hold, .duration = undefined, .force = change_of(data.force, ends)};
    const Array1D& time = record.loop.time;
    if (time.size() > 0) growth.duration = time[contact.hold->last] - time[contact.hold->first];
    if (data.displacement.size() > 0) growth.displacement = change_of(data.displacement, ends);
    if (data.contact_radius.size() == 0) return growth;
    growth.contact_radius = change_of(data.contact_radius, ends);
    growth.work_of_adhesion = change_of(
        energy_release_rates(data, bodies.radius, loading.primary().contact_modulus.value, 0.0).energy_release_rate,
        ends);
    return growth;
}

}  // namespace setae::loops
