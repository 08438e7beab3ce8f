// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "evidence.hpp"
#include "setae/core/constants.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::diagnostics {
namespace {

/// What is removed counts as large where its rms is more than so many times that of what remains: a surface without
/// roll-off, H = 0.8, shows a tilt of once or twice its remaining rms by chance.
constexpr double large_tilt_ratio = 3.0;
constexpr double large_curvature_ratio = 1.5;

double removed_rms(double before, double after) { return std::sqrt(std::max(0.0, before * before - after * after)); }

/// Ends of the best line through x, h: rise over the size.
double slope_along(const Array2D& removed, double step, bool along_x) {
    double sum = 0.0;
    Index n = 0;
    const Index di = along_x ? 1 : 0, dj = along_x ? 0 : 1;
    for (Index i = 0; i + di < removed.rows(); ++i)
        for (Index j = 0; j + dj < removed.cols(); ++j) {
            const double rise = removed(i + di, j + dj) - removed(i, j);
            if (!std::isnan(rise)) sum += rise, ++n;
        }
    return n > 0 ? sum / static_cast<double>(n) / step : 0.0;
}

/// Curvature of a parabola along x [1/m], from its second differences.
double curvature_along(const Array2D& removed, double step, bool along_x) {
    double sum = 0.0;
    Index n = 0;
    const Index di = along_x ? 1 : 0, dj = along_x ? 0 : 1;
    for (Index i = di; i + di < removed.rows(); ++i)
        for (Index j = dj; j + dj < removed.cols(); ++j) {
            const double bend = removed(i + di, j + dj) - 2.0 * removed(i, j) + removed(i - di, j - dj);
            if (!std::isnan(bend)) sum += bend, ++n;
        }
    return n > 0 ? sum / static_cast<double>(n) / (step * step) : 0.0;
}

Array2D without_parabola(const Evidence& evidence, parallel::Threads threads) {
    if (!evidence.is_line) return topography::detrended(*evidence.level, topography::Trend::parabola, threads).heights;
    const topography::LineScan line{evidence.level->heights.col(0), evidence.level->size[0], false, {}};
    return topography::detrended(line, topography::Trend::parabola).heights;
}

}  // namespace

Found undefined_heights(const Evidence& evidence) {
    const Index all = evidence.map->heights.size(), missing = all - evidence.defined;
    if (missing == 0) return {};
    const double share = static_cast<double>(missing) / static_cast<double>(all);
    return Finding{{"UNDEF", evidence.subject,
                    fmt::format("{} of {} heights are undefined ({:.2g} %)", missing, all, 100.0 * share),
                    "crop ragged borders and fill small holes before transforms; statistics of heights leave them out"},
                   {effect("undefined_share", "", share, "1"), effect_count("undefined_heights", missing)}};
}

Found large_tilt(const Evidence& evidence) {
    const double before = evidence.rms_map, after = evidence.rms_level, tilt = removed_rms(before, after);
    if (!(tilt > large_tilt_ratio * after)) return {};
    const Array2D plane = evidence.map->heights - evidence.level->heights;
    const auto pixel = evidence.map->pixel_size();
    const double along_x = slope_along(plane, pixel[0], true),
                 along_y = evidence.is_line ? 0.0 : slope_along(plane, pixel[1], false);
    const double slope = std::hypot(along_x, along_y);
    return Finding{
        {"TILT_LARGE", evidence.subject,
         fmt::format("the heights are tilted by {:.3g} ({:.3g} degrees): with it rms height is {}, without {}", slope,
                     std::atan(slope) * 180.0 / pi, length_text(before), length_text(after)),
         "remove a plane (of a line its mean line) before height parameters and spectra"},
        {effect("tilt", "", slope, "1"), effect("tilt_x", "", along_x, "1"), effect("tilt_y", "", along_y, "1"),
         effect("rms_height_as_measured", "h_rms", before, "m"),
         effect("rms_height_without_tilt", "h_rms", after, "m")}};
}

Found curvature_left(const Evidence& evidence, parallel::Threads threads) {
    const Index needed = 12;
    if (evidence.map->heights.rows() < needed || (!evidence.is_line && evidence.map->heights.cols() < needed) ||
        evidence.defined < 2 * needed)
        return {};
    const Array2D rest = without_parabola(evidence, threads);
    const double before = evidence.rms_level, after = rms_height(rest), bow = removed_rms(before, after);
    if (!(bow > large_curvature_ratio * after)) return {};
    const Array2D bowl = evidence.level->heights - rest;
    const auto pixel = evidence.map->pixel_size();
    const double along_x = curvature_along(bowl, pixel[0], true),
                 along_y = evidence.is_line ? 0.0 : curvature_along(bowl, pixel[1], false);
    const double strongest = std::abs(along_x) > std::abs(along_y) ? along_x : along_y;
    return Finding{{"CURVATURE_LEFT", evidence.subject,
                    fmt::format("the level surface is bowed with a radius of {}: with it rms height is {}, without {}",
                                length_text(1.0 / std::abs(strongest)), length_text(before), length_text(after)),
                    "remove a parabola where the sample's form or the scanner's bow is not what you study"},
                   {effect("curvature_x", "", along_x, "1/m"), effect("curvature_y", "", along_y, "1/m"),
                    effect("rms_height_with_curvature", "h_rms", before, "m"),
                    effect("rms_height_without_curvature", "h_rms", after, "m")}};
}

}  // namespace setae::diagnostics
