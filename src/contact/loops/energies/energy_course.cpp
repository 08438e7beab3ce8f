// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "records/jump.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/energy_budget.hpp"

namespace setae::loops {
namespace {

/// The samples in contact.
IndexRange touching(const Loop& loop, const ContactSegments& contact) {
    IndexRange range{contact.loading.first, contact.extent.last};
    if (contact.unloading) range.last = contact.unloading->last;
    if (contact.pull_off) range.last = largest_step(loop.force, *contact.pull_off);
    if (loop.contact_radius.size() == 0) return range;
    // frames determine better where contact ends
    for (Index i = contact.pull_off ? contact.pull_off->last : range.last; i >= range.first; --i)
        if (loop.contact_radius[i] > 0.0) return {range.first, std::max(i, contact.loading.last)};
    return range;
}

/// Radii between frames by linear interpolation, constant before the first and after the last.
Array1D between_frames(const Array1D& radius, const IndexRange& range) {
    Array1D filled(range.count());
    Index before = -1;
    for (Index i = range.first; i <= range.last + 1; ++i) {
        const bool frame = i <= range.last && radius[i] > 0.0;
        if (!frame && i <= range.last) continue;
        for (Index k = before < 0 ? range.first : before + 1; k < i; ++k) {
            if (!frame) filled[k - range.first] = before < 0 ? 0.0 : radius[before];
            else if (before < 0) filled[k - range.first] = radius[i];
            else
                filled[k - range.first] = radius[before] + (radius[i] - radius[before]) *
                                                               static_cast<double>(k - before) /
                                                               static_cast<double>(i - before);
        }
        if (frame) filled[i - range.first] = radius[i];
        before = i;
    }
    return filled;
}

Array1D implied_radii(const Array1D& force, const Array1D& displacement, const contact::SphereOnFlat& bodies) {
    Array1D radii(force.size());
    double last = 0.0;
    for (Index i = 0; i < radii.size(); ++i) {
        const double a = contact::jkr::contact_radius_at(force[i], displacement[i], bodies);
        radii[i] = last = a > 0.0 ? a : last;
    }
    return radii;
}

}  // namespace

EnergyCourse energy_course(const Loop& loop, const ContactSegments& contact, const CourseInputs& inputs) {
    if (loop.displacement.size() == 0)
        throw UndefinedDataError("the course of energies needs the displacement, which was not measured");
    const auto& [R, E, W] = inputs.contact;
    const Index first = contact.extent.first, n = contact.extent.count();
    EnergyCourse course{.range = contact.extent, .radius_measured = loop.contact_radius.size() > 0};
    const Array1D force = loop.force.segment(first, n),
                  displacement = loop.displacement.segment(first, n) - inputs.contact_point;
    course.work = Array1D::Zero(n);
    for (Index i = 1; i < n; ++i)
        course.work[i] = course.work[i - 1] + 0.5 * (force[i - 1] + force[i]) * (displacement[i] - displacement[i - 1]);

    const IndexRange touch = touching(loop, contact);
    const Index start = touch.first - first, count = touch.count(), end = start + count - 1;
    course.contact_radius = Array1D::Zero(n);
    course.contact_radius.segment(start, count) =
        course.radius_measured ? between_frames(loop.contact_radius, touch)
                               : implied_radii(force.segment(start, count), displacement.segment(start, count), {R, E});
    const Array1D& a = course.contact_radius;
    const Array1D cubed = a.cube();
    course.elastic =
        E * (displacement.square() * a - 2.0 / 3.0 * displacement * cubed / R + cubed * a.square() / (5.0 * R * R));
    course.surface = -W * pi * a.square();
    course.dissipated = course.work - course.elastic - course.surface;

    course.released = Array1D::Zero(n);
    const auto release_rate = [&](Index i) {
        return a[i] > 0.0 ? contact::jkr::energy_release_rate_at_displacement(a[i], displacement[i], {R, E}) : 0.0;
    };
    double rate = release_rate(start);
    for (Index i = start + 1; i <= end; ++i) {
        const double next = release_rate(i);
        course.released[i] = course.released[i - 1] + 0.5 * (rate + next) * pi * (a[i] * a[i] - a[i - 1] * a[i - 1]);
        rate = next;
    }
    if (end + 1 < n) course.released.tail(n - end - 1) = course.released[end];
    course.residual =
        course.work[end] - course.work[start] - (course.elastic[end] - course.elastic[start]) + course.released[end];
    return course;
}

}  // namespace setae::loops
