// SPDX-License-Identifier: GPL-3.0-or-later
#include "bulk_relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

/// Contact radii of a section of the record, interpolated linearly between frames; where none was measured, computed
/// from F and δ.
Array1D radii_between_frames(const Loop& record, Index first, Index count, double contact_point,
                             const contact::SphereOnFlat& bodies) {
    Array1D radii(count);
    if (record.contact_radius.size() == 0) {
        for (Index i = 0; i < count; ++i) {
            const double a = contact::jkr::contact_radius_at(record.force[first + i],
                                                             record.displacement[first + i] - contact_point, bodies);
            radii[i] = std::isfinite(a) ? a : (i > 0 ? radii[i - 1] : 0.0);
        }
        return radii;
    }
    const auto is_frame = [&](Index i) { return record.contact_radius[first + i] > 0.0; };
    Index before = -1;
    for (Index i = 0; i < count; ++i) {
        if (!is_frame(i)) continue;
        const double here = record.contact_radius[first + i];
        const double there = before < 0 ? here : radii[before];
        for (Index k = before + 1; k < i; ++k)
            radii[k] = before < 0
                           ? here
                           : there + (here - there) * static_cast<double>(k - before) / static_cast<double>(i - before);
        radii[i] = here;
        before = i;
    }
    if (before < 0)
        throw UndefinedDataError(
            "the relaxation of the bulk cannot be computed: no frame of the camera shows the contact");
    for (Index k = before + 1; k < count; ++k) radii[k] = radii[before];
    return radii;
}

/// Radii that increase to the turn and decrease after it.
void make_monotonic(Array1D& radii, Index turn) {
    for (Index i = 1; i <= turn; ++i) radii[i] = std::max(radii[i], radii[i - 1]);
    for (Index i = turn + 1; i < radii.size(); ++i) radii[i] = std::min(radii[i], radii[i - 1]);
}

}  // namespace

BulkForce bulk_force(const LoopAnalysis& analysis, const LensAndCounterBody& bodies,
                     const std::vector<contact::RelaxationTerm>& terms) {
    const auto& record = analysis.corrected;
    const auto& contact = analysis.segments.contacts.front();
    if (record.time.size() == 0 || record.displacement.size() == 0)
        throw UndefinedDataError(
            "the relaxation of the bulk needs time and displacement of the record, which were not measured");
    if (!contact.unloading)
        throw UndefinedDataError(
            "the relaxation of the bulk needs a record that continues until the contact separates");
    const double modulus = analysis.loading.primary().contact_modulus.value;
    const contact::SphereOnFlat sphere{bodies.radius, modulus};
    const double contact_point = analysis.contact_points ? analysis.contact_points->contact_point.value : 0.0;
    BulkForce bulk{.first = contact.jump_in ? contact.jump_in->last : contact.loading.first};
    const Index last = contact.pull_off ? contact.pull_off->last - 1 : contact.unloading->last;  // in contact
    const Index count = last - bulk.first + 1;
    contact::ContactHistory history{
        .time = record.time.segment(bulk.first, count),
        .displacement = record.displacement.segment(bulk.first, count) - contact_point,
        .contact_radius = radii_between_frames(record, bulk.first, count, contact_point, sphere),
        .turn = std::min(contact.loading.last, contact.unloading->last) - bulk.first};
    make_monotonic(history.contact_radius, history.turn);
    bulk.force = contact::relaxation_force(history, bodies.radius, modulus, terms);
    bulk.relaxation.energy_loss = contact::relaxation_loss(history, bodies.radius, modulus, terms);
    bulk.relaxation.largest_force = bulk.force.abs().maxCoeff();
    return bulk;
}

}  // namespace setae::loops
