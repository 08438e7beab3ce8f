// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/afm.hpp"

#include <cmath>

#include <fmt/format.h>

#include "instrument.hpp"
#include "setae/core/errors.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::simulation {
namespace {

void check(const AfmOptions& options) {
    if (options.nx < 2 || options.ny < 2 || !(options.size > 0.0) || !std::isfinite(options.size))
        throw InvalidArgument(
            fmt::format("afm map of {} by {} points over {} m; expected at least 2 by 2 and a positive length",
                        options.nx, options.ny, options.size));
    require_not_negative(options.noise_rms, "rms noise [m] of the afm");
    require_not_negative(options.line_offset_rms, "rms line offset [m] of the afm");
    require_not_negative(options.line_drift_rms, "rms line drift [m] of the afm");
    require_not_negative(options.feedback_lag, "feedback lag [m] of the afm");
    require_finite(options.tilt_x, "tilt along x of the afm map");
    require_finite(options.tilt_y, "tilt along y of the afm map");
    require_finite(options.bow, "bow [m] of the afm map");
}

/// The surface's readings at the pixels, x along rows.
Array2D readings_at_pixels(const topography::Dilator& touched, const AfmOptions& options, double pixel) {
    Array1D x(options.nx * options.ny), y(options.nx * options.ny);
    for (Index i = 0; i < options.nx; ++i) {
        x.segment(i * options.ny, options.ny).setConstant(options.start_x + static_cast<double>(i) * pixel);
        y.segment(i * options.ny, options.ny) =
            Array1D::LinSpaced(options.ny, 0.0, static_cast<double>(options.ny - 1)) * pixel + options.start_y;
    }
    const Array1D readings = touched.readings(x, y);
    return Eigen::Map<const Array2D>(readings.data(), options.nx, options.ny);
}

/// λ dz/dx + z = u solved exactly for u linear between points; a line is constant over undefined points.
void lag_line(Array2D& heights, Index line, double step, double lag) {
    const double decay = std::exp(-step / lag);
    double followed = 0.0, before = 0.0;
    bool started = false, held = true;
    for (Index i = 0; i < heights.rows(); ++i) {
        const double target = heights(i, line);
        if (std::isnan(target)) {
            held = true;
            continue;
        }
        // across a hole the height is undefined: it steps to the new height
        if (held) before = target;
        if (!started) followed = target;
        started = true;
        held = false;
        const double trail = (target - before) / step * lag;
        followed = target - trail + (followed - before + trail) * decay;
        before = target;
        heights(i, line) = followed;
    }
}

/// Offset and drift of each line.
Array1D line_shifts(const AfmOptions& options) {
    Array1D shifts = options.line_offset_rms * numerics::normal_numbers(substream(options.key, 1), 0, options.ny);
    const Array1D steps = numerics::normal_numbers(substream(options.key, 2), 0, options.ny);
    double walked = 0.0;
    for (Index j = 1; j < options.ny; ++j) {
        walked += options.line_drift_rms * steps[j];
        shifts[j] += walked;
    }
    return shifts;
}

}  // namespace

topography::HeightMap afm_map(const topography::HeightMap& surface, const AfmOptions& options) {
    return afm_map(topography::Dilator(surface, options.tip, options.touch), options);
}

topography::HeightMap afm_map(const topography::Dilator& touched, const AfmOptions& options) {
    check(options);
    return recorded_map(readings_at_pixels(touched, options, options.size / static_cast<double>(options.nx)), options);
}

topography::HeightMap recorded_map(Array2D readings, const AfmOptions& options) {
    check(options);
    if (readings.rows() != options.nx || readings.cols() != options.ny)
        throw InvalidArgument(fmt::format("{} by {} readings of an afm map of {} by {} points", readings.rows(),
                                          readings.cols(), options.nx, options.ny));
    const double pixel = options.size / static_cast<double>(options.nx);
    topography::HeightMap map{std::move(readings),
                              {options.size, static_cast<double>(options.ny) * pixel},
                              false,
                              simulated_with_tip("afm", options.tip, options.tip_radius_standard_error)};
    if (options.feedback_lag > 0.0)
        for (Index j = 0; j < options.ny; ++j) lag_line(map.heights, j, pixel, options.feedback_lag);
    const Array1D shifts = line_shifts(options);
    parallel::for_each_index(static_cast<std::size_t>(options.nx), options.touch.threads, [&](std::size_t row) {
        const auto i = static_cast<Index>(row);
        const Array1D noise =
            numerics::normal_numbers(substream(options.key, 0), static_cast<std::uint64_t>(i * options.ny), options.ny);
        const double share = static_cast<double>(i) / static_cast<double>(options.nx - 1);
        const double along_x = options.tilt_x * static_cast<double>(i) * pixel + bow_at(options.bow, share);
        for (Index j = 0; j < options.ny; ++j)
            map.heights(i, j) +=
                along_x + options.tilt_y * static_cast<double>(j) * pixel + shifts[j] + options.noise_rms * noise[j];
    });
    return map;
}

}  // namespace setae::simulation
