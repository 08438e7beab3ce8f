// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/loop_drive.hpp"

#include <algorithm>
#include <cmath>

namespace setae::loops {
namespace {

constexpr Index min_of_a_motion = 5;

/// Straight line through samples of the motor's position.
struct Motion {
    double speed = 0.0;              ///< [m/s]
    double time = 0.0, place = 0.0;  ///< means: a point of the line
};

std::optional<Motion> motion(const Array1D& time, const Array1D& position, Index first, Index last) {
    const Index n = last - first + 1;
    if (n < min_of_a_motion) return std::nullopt;
    const Array1D t = time.segment(first, n), x = position.segment(first, n);
    const double mean_time = t.mean(), mean_place = x.mean();
    const double spread = (t - mean_time).square().sum();
    if (!(spread > 0.0)) return std::nullopt;
    return Motion{((t - mean_time) * (x - mean_place)).sum() / spread, mean_time, mean_place};
}

}  // namespace

std::optional<LoopDrive> loop_drive(const LoopAnalysis& analysis, double machine_stiffness) {
    const auto& record = analysis.corrected;
    const auto& contact = analysis.segments.contacts.front();
    if (record.time.size() == 0 || record.displacement.size() == 0 || !contact.unloading) return std::nullopt;
    const Array1D position = record.displacement + record.force / machine_stiffness;
    const auto along = [&](Index first, Index last) { return motion(record.time, position, first, last); };

    const Index touched = contact.jump_in ? contact.jump_in->first : contact.loading.first;
    auto coming = along(contact.extent.first, touched - 1);
    if (!coming || !(coming->speed > 0.0)) coming = along(contact.loading.first, contact.loading.last);
    const Index parted = contact.pull_off ? contact.pull_off->last : contact.unloading->last;
    auto going = along(parted + 1, contact.extent.last);
    if (!going || !(going->speed < 0.0)) going = along(contact.unloading->first, contact.unloading->last);
    if (!coming || !going || !(coming->speed > 0.0) || !(going->speed < 0.0)) return std::nullopt;

    const double top =
        position.segment(contact.extent.first, contact.extent.last - contact.extent.first + 1).maxCoeff();
    const double arrived = coming->time + (top - coming->place) / coming->speed;
    const double left = going->time + (top - going->place) / going->speed;
    const double sample = (record.time[record.time.size() - 1] - record.time[0]) /
                          static_cast<double>(std::max<Index>(1, record.time.size() - 1));
    LoopDrive drive{.approach_speed = coming->speed, .retraction_speed = -going->speed};
    constexpr double between_samples = 3.0;  // the turn itself is between two samples
    if (left - arrived > between_samples * sample) drive.hold_time = left - arrived;
    return drive;
}

}  // namespace setae::loops
