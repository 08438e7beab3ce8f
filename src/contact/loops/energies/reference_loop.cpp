// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/reference_loop.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

Estimate retraction_work(const LoopAnalysis& analysis) {
    if (analysis.retraction) return analysis.retraction->work_of_adhesion;
    if (analysis.unloading) return analysis.unloading->primary().work_of_adhesion;
    throw UndefinedDataError("a reference needs the retraction: " + analysis.unloading.reason);
}

}  // namespace

ReferenceLoop evaluate_reference(const LoopAnalysis& analysis) {
    if (!analysis.loop) throw UndefinedDataError("a reference needs the loop's energy: " + analysis.loop.reason);
    ReferenceLoop reference{.work_of_adhesion_loading = analysis.loading.primary().work_of_adhesion,
                            .work_of_adhesion_retraction = retraction_work(analysis),
                            .excess_energy = analysis.loop->estimate(),
                            .ideal_loss = analysis.context.ideal_smooth_sphere_loss,
                            .contact_area = analysis.context.largest_contact_area};
    const Estimate gap = difference(reference.work_of_adhesion_retraction, reference.work_of_adhesion_loading);
    reference.difference_in_standard_errors = std::abs(gap.value) / gap.standard_error;
    reference.beyond_ideal = reference.excess_energy.value - reference.ideal_loss;
    return reference;
}

Array1D loss_ratios(const ArrayView1D& rough_losses, const std::vector<ReferenceLoop>& references) {
    if (references.empty()) throw UndefinedDataError("no reference loop is given; comparing losses needs one or more");
    double mean = 0.0;
    for (const ReferenceLoop& reference : references) mean += reference.excess_energy.value;
    mean /= static_cast<double>(references.size());
    if (!(mean > 0.0))
        throw InvalidArgument(fmt::format("mean excess energy of the references must be > 0 J, got {}", mean));
    return rough_losses / mean;
}

ReferenceChange change(const ReferenceLoop& before, const ReferenceLoop& after) {
    return {.work_of_adhesion_loading = difference(after.work_of_adhesion_loading, before.work_of_adhesion_loading),
            .work_of_adhesion_retraction =
                difference(after.work_of_adhesion_retraction, before.work_of_adhesion_retraction),
            .excess_energy = difference(after.excess_energy, before.excess_energy)};
}

}  // namespace setae::loops
