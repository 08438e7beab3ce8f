// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/clocks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::tables {
namespace {

const Array1D& required(const Table& table, const char* name, const char* unit, const char* subject) {
    const auto* column = table.find(name);
    if (!column) throw InvalidArgument(fmt::format("{}: no column '{}'", subject, name));
    if (column->unit != unit)
        throw InvalidArgument(
            fmt::format("{}: column '{}' has the unit '{}', expected '{}'", subject, name, column->unit, unit));
    return column->values;
}

void require_forwards(const Array1D& time, const std::string& subject) {
    for (Index i = 0; i < time.size(); ++i) {
        if (!std::isfinite(time[i]))
            throw InvalidArgument(fmt::format("{}: time is undefined in row {} of {}", subject, i + 1, time.size()));
        if (i > 0 && time[i] <= time[i - 1])
            throw InvalidArgument(fmt::format(
                "{}: time {} from row {} to {}, from {} s to {} s; expected times that increase", subject,
                time[i] < time[i - 1] ? "runs backwards" : "does not change", i, i + 1, time[i - 1], time[i]));
    }
}

/// Index of the time nearest to t; the earlier of two equally near.
Index nearest(const Array1D& time, double t) {
    const auto after = std::lower_bound(time.begin(), time.end(), t) - time.begin();
    if (after == 0) return 0;
    if (after == time.size()) return time.size() - 1;
    return t - time[after - 1] <= time[after] - t ? after - 1 : after;
}

/// Half the step to the neighbour on the side of t.
double half_step(const Array1D& time, Index sample, double t) {
    const bool later = t >= time[sample];
    const Index last = time.size() - 1;
    const Index other = later ? (sample < last ? sample + 1 : sample - 1) : (sample > 0 ? sample - 1 : sample + 1);
    return 0.5 * std::abs(time[other] - time[sample]);
}

/// Index of the last defined value of a series, from 0; −1 if there is none.
Index last_defined(const Array1D& values) {
    Index last = values.size() - 1;
    while (last >= 0 && std::isnan(values[last])) --last;
    return last;
}

}  // namespace

void require_one_clock(const Table& table, const std::string& subject) {
    for (const auto& column : table.columns)
        if (column.values.size() != table.rows())
            throw InvalidArgument(fmt::format("{}: channels of different length: column '{}' has {} rows, '{}' has {}",
                                              subject, column.name, column.values.size(), table.columns.front().name,
                                              table.rows()));
    for (const char* name : {"force", "displacement", "time"}) {
        const auto* column = table.find(name);
        if (!column) continue;
        const auto last = last_defined(column->values);
        if (last < 0) throw InvalidArgument(fmt::format("{}: column '{}' has no numbers", subject, name));
        if (last + 1 < table.rows())
            throw InvalidArgument(fmt::format(
                "{}: channels of different length: column '{}' ends in row {} of {}; cut the others there or "
                "bring all onto one clock",
                subject, name, last + 1, table.rows()));
    }
    if (const auto* time = table.find("time")) require_forwards(time->values, subject);
}

Table merged_by_time(const Table& force_table, const Table& camera_table, double offset) {
    if (!std::isfinite(offset))
        throw InvalidArgument(fmt::format("an offset of {} s between the clocks, expected a finite one", offset));
    const auto& time = required(force_table, "time", "s", "force record");
    const auto& frames = required(camera_table, "time", "s", "camera record");
    const auto& radius = required(camera_table, "contact_radius", "m", "camera record");
    if (force_table.find("contact_radius"))
        throw InvalidArgument("force record: it already has a contact radius; leave this column out of its mapping");
    if (time.size() < 2 || frames.size() < 1)
        throw InvalidArgument(
            fmt::format("{} samples of force and {} frames, expected at least two of force and one frame", time.size(),
                        frames.size()));
    if (frames.size() != radius.size())
        throw InvalidArgument(fmt::format("camera record: {} times for {} radii; expected one time per radius",
                                          frames.size(), radius.size()));
    require_forwards(time, "force record");
    require_forwards(frames, "camera record");

    Array1D merged = Array1D::Constant(time.size(), undefined), shift = Array1D::Constant(time.size(), undefined);
    Index used = 0, outside = 0, crowded = 0;
    for (Index i = 0; i < frames.size(); ++i) {
        const double t = frames[i] + offset;
        const auto sample = nearest(time, t);
        const double moved = std::abs(t - time[sample]);
        const bool within = t >= time[0] && t <= time[time.size() - 1];
        if (!within && moved > half_step(time, sample, t)) {
            ++outside;
            continue;
        }
        const bool taken = !std::isnan(shift[sample]);
        crowded += taken ? 1 : 0;
        used += taken ? 0 : 1;
        if (taken && moved >= shift[sample]) continue;
        shift[sample] = moved;
        merged[sample] = radius[i];
    }
    if (used == 0)
        throw InvalidArgument(fmt::format(
            "the clocks do not overlap: force from {} s to {} s, frames from {} s to {} s with the offset; check the offset",
            time[0], time[time.size() - 1], frames[0] + offset, frames[frames.size() - 1] + offset));
    Table result = force_table;
    result.columns.push_back({"contact_radius", "m", merged});
    result.metadata["camera_clock_offset"] = fmt::format("{} s", offset);
    result.metadata["frames_used"] = fmt::format("{}", used);
    result.metadata["frames_outside"] = fmt::format("{}", outside);
    result.metadata["frames_crowded"] = fmt::format("{}", crowded);
    double largest = 0.0;
    for (const double moved : shift) largest = std::isnan(moved) ? largest : std::max(largest, moved);
    result.metadata["largest_frame_shift"] = fmt::format("{} s", largest);
    return result;
}

}  // namespace setae::tables
