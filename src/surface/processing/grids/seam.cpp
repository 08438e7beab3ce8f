// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/seam.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/step_record.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using topography::LineScan;

/// Mean and mean square of the step from one row to another.
struct Step {
    double mean = 0.0, square = 0.0;
};

template <class Row>
Step step_between(const Row& from, const Row& to) {
    Step step;
    double count = 0.0;
    for (Index j = 0; j < from.size(); ++j) {
        const double d = to(j) - from(j);
        if (!std::isfinite(d)) continue;
        step.mean += d;
        step.square += d * d;
        count += 1.0;
    }
    if (count > 0.0) {
        step.mean /= count;
        step.square /= count;
    }
    return step;
}

/// row(i): heights of row i of n.
template <class Rows>
Seam seam_between(Index n, const Rows& row) {
    constexpr double max_rms = 2.0, max_mean = 3.0, rounding = 1e-12;
    double square = 0.0, square_of_means = 0.0;
    for (Index i = 0; i + 1 < n; ++i) {
        const auto step = step_between(row(i), row(i + 1));
        square += step.square;
        square_of_means += step.mean * step.mean;
    }
    const auto pairs = static_cast<double>(n - 1);
    const auto seam = step_between(row(n - 1), row(0));
    const double height_step = std::sqrt(seam.square), usual = std::sqrt(square / pairs);
    const double usual_mean = std::sqrt(square_of_means / pairs), slack = rounding * usual;
    return {height_step, usual,
            height_step <= max_rms * usual + slack && std::abs(seam.mean) <= max_mean * usual_mean + slack};
}

/// w at each of n points.
Array1D window_of(Index n, double share) {
    Array1D window = Array1D::Ones(n);
    const double width = share * static_cast<double>(n);
    for (Index i = 0; i < n; ++i) {
        const double from_edge = static_cast<double>(std::min(i, n - 1 - i)) + 0.5;
        if (from_edge < width) window[i] = std::pow(std::sin(0.5 * pi * from_edge / width), 2);
    }
    return window;
}

template <class Heights>
double mean_of_defined(const Heights& heights) {
    double sum = 0.0, count = 0.0;
    for (Index i = 0; i < heights.size(); ++i)
        if (const double h = heights.data()[i]; std::isfinite(h)) sum += h, count += 1.0;
    return count > 0.0 ? sum / count : 0.0;
}

/// The share of the points that were changed.
double taper(HeightMap& map, double share) {
    const auto x = window_of(map.heights.rows(), share), y = window_of(map.heights.cols(), share);
    const double mean = mean_of_defined(map.heights);
    for (Index i = 0; i < x.size(); ++i) {
        const Array1D window = x[i] * y;  // heights are unchanged where it is 1
        map.heights.row(i) = map.heights.row(i) * window.transpose() + mean * (1.0 - window.transpose());
    }
    const auto whole = static_cast<double>((x == 1.0).count()) * static_cast<double>((y == 1.0).count());
    return 1.0 - whole / static_cast<double>(map.heights.size());
}

double taper(LineScan& scan, double share) {
    const auto window = window_of(scan.heights.size(), share);
    const double mean = mean_of_defined(scan.heights);
    scan.heights = scan.heights * window + mean * (1.0 - window);
    return 1.0 - static_cast<double>((window == 1.0).count()) / static_cast<double>(scan.heights.size());
}

}  // namespace

Seam seam_of(const topography::Measurement& measurement) {
    if (const auto* map = std::get_if<HeightMap>(&measurement)) {
        const auto& h = map->heights;
        const auto x = seam_between(h.rows(), [&](Index i) { return h.row(i); });
        const auto y = seam_between(h.cols(), [&](Index j) { return h.col(j); });
        auto seam = x.height_step >= y.height_step ? x : y;
        seam.closed = x.closed && y.closed;
        return seam;
    }
    if (const auto* scan = std::get_if<LineScan>(&measurement))
        return seam_between(scan->heights.size(), [&](Index i) { return scan->heights.segment(i, 1); });
    return {};
}

Processed windowed(topography::Measurement measurement, double share) {
    if (!(share > 0.0 && share <= 0.5))
        throw InvalidArgument(
            fmt::format("the window covers {} of the extent at each edge; expected above 0 and up to 0.5", share));
    StepRecord record{"window_edges", {}, {}};
    record.numbers.push_back(recorded("height_step_at_seam", "", seam_of(measurement).height_step, "m"));
    double changed = 0.0;
    if (auto* map = std::get_if<HeightMap>(&measurement)) {
        changed = taper(*map, share);
        map->periodic = true;
    } else if (auto* scan = std::get_if<LineScan>(&measurement)) {
        changed = taper(*scan, share);
        scan->periodic = true;
    } else
        throw InvalidArgument(
            fmt::format("{}: the points of a profile are not equally spaced; expected a map or a line",
                        topography::label(topography::metadata(measurement))));
    record.numbers.push_back(recorded("windowed_share", "", changed, "1"));
    if (auto rms = rms_height(measurement, {})) record.numbers.push_back(std::move(*rms));
    return {std::move(measurement), std::move(record)};
}

}  // namespace setae::processing
