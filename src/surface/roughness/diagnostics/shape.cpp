// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "evidence.hpp"
#include "rms_heights.hpp"
#include "setae/core/constants.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::diagnostics {
namespace {

/// A subtracted form is large if its rms exceeds that of the rest by this factor: a surface without roll-off, H = 0.8,
/// has by chance a tilt of once or twice its remaining rms.
constexpr double large_tilt_ratio = 3.0;
constexpr double large_curvature_ratio = 1.5;

double removed_rms(double before, double after) { return std::sqrt(std::max(0.0, before * before - after * after)); }

/// Rows of a map that are computed on request, a few at a time; load(i, row).
template <class Load>
class FewRows {
public:
    FewRows(Index rows, Index columns, Load load) : load_(std::move(load)), rows_(rows), kept_(3, columns) {}

    [[nodiscard]] Index rows() const { return rows_; }
    [[nodiscard]] Index columns() const { return kept_.cols(); }
    /// Row i, valid until three others are requested.
    [[nodiscard]] const double* row(Index i) {
        auto& holds = held_[static_cast<std::size_t>(i % 3)];
        double* const values = kept_.row(i % 3).data();
        if (holds != i) load_(i, values);
        holds = i;
        return values;
    }

private:
    Load load_;
    Index rows_;
    Array2D kept_;
    std::array<Index, 3> held_{-1, -1, -1};
};

/// Mean of `difference` of a point and those around it, over all points sufficiently inside and with a defined value; 0
/// if there is none.
template <class Rows, class Difference>
double mean_difference(Rows& rows, Index before_i, Index after_i, Index before_j, Index after_j,
                       const Difference& difference) {
    double sum = 0.0;
    Index n = 0;
    for (Index i = before_i; i + after_i < rows.rows(); ++i) {
        const double *const last = rows.row(i - before_i), *const here = rows.row(i),
                            *const next = rows.row(i + after_i);
        for (Index j = before_j; j + after_j < rows.columns(); ++j) {
            const double value = difference(last + j - before_j, here + j, next + j + after_j);
            if (!std::isnan(value)) {
                sum += value;
                ++n;
            }
        }
    }
    return n > 0 ? sum / static_cast<double>(n) : 0.0;
}

/// Height of the best line over the whole size.
template <class Rows>
double slope_along(Rows& rows, double step, bool along_x) {
    const auto rise = [](const double*, const double* here, const double* next) { return *next - *here; };
    return mean_difference(rows, 0, along_x ? 1 : 0, 0, along_x ? 0 : 1, rise) / step;
}

/// Curvature of a parabola along x or y [1/m], from its second differences.
template <class Rows>
double curvature_along(Rows& rows, double step, bool along_x) {
    const auto bend = [](const double* last, const double* here, const double* next) {
        return *next - 2.0 * *here + *last;
    };
    const Index di = along_x ? 1 : 0, dj = along_x ? 0 : 1;
    return mean_difference(rows, di, di, dj, dj, bend) / (step * step);
}

/// Rms of the map, of the level heights, and of these without their parabola.
std::array<double, 3> rms_of_three(const Evidence& evidence, const topography::MapTrend& parabola) {
    const auto &map = evidence.map->heights, &level = evidence.heights.heights;
    Array1D rest(level.cols());
    return rms_heights<3>(level.rows(), level.cols(), [&](Index i) {
        parabola.take_from(i, level.row(i).data(), rest.data());
        return std::array<const double*, 3>{map.row(i).data(), level.row(i).data(), rest.data()};
    });
}

std::array<double, 2> rms_of_two(const Evidence& evidence) {
    const auto &map = evidence.map->heights, &level = evidence.heights.heights;
    return rms_heights<2>(level.rows(), level.cols(), [&](Index i) {
        return std::array{map.row(i).data(), level.row(i).data()};
    });
}

/// A line without its parabola.
Array2D line_without_parabola(const Evidence& evidence) {
    const topography::LineScan line{evidence.heights.heights.col(0), evidence.heights.size[0], false, {}};
    return topography::detrended(line, topography::Trend::parabola).heights;
}

bool enough_for_parabola(const Evidence& evidence) {
    constexpr Index needed = 12;
    const auto& heights = evidence.heights.heights;
    return heights.rows() >= needed && (evidence.is_line || heights.cols() >= needed) && evidence.defined >= 2 * needed;
}

/// Curvatures of the parabola subtracted from the level heights, along x and y [1/m].
std::array<double, 2> curvatures_of_bowl(const Evidence& evidence) {
    const auto& level = evidence.heights.heights;
    const auto pixel = evidence.map->pixel_size();
    const auto both = [&](auto rows) {
        return std::array{curvature_along(rows, pixel[0], true),
                          evidence.is_line ? 0.0 : curvature_along(rows, pixel[1], false)};
    };
    if (evidence.is_line) {
        const Array2D bowl = level - line_without_parabola(evidence);
        return both(FewRows(level.rows(), level.cols(), [&](Index i, double* row) { *row = bowl(i, 0); }));
    }
    return both(FewRows(level.rows(), level.cols(), [&](Index i, double* row) {
        evidence.form.parabola->take_from(i, level.row(i).data(), row);
        for (Index j = 0; j < level.cols(); ++j) row[j] = level(i, j) - row[j];
    }));
}

}  // namespace

Form form_of(const Evidence& evidence, parallel::Threads threads) {
    Form form;
    if (enough_for_parabola(evidence) && !evidence.is_line) {
        form.parabola.emplace(evidence.heights.heights, topography::Trend::parabola, threads);
        const auto rms = rms_of_three(evidence, *form.parabola);
        form.rms_map = rms[0];
        form.rms_level = rms[1];
        form.rms_without_parabola = rms[2];
        return form;
    }
    const auto rms = rms_of_two(evidence);
    form.rms_map = rms[0];
    form.rms_level = rms[1];
    if (enough_for_parabola(evidence)) form.rms_without_parabola = rms_height(line_without_parabola(evidence));
    return form;
}

Found undefined_heights(const Evidence& evidence) {
    const Index all = evidence.map->heights.size(), missing = all - evidence.defined;
    if (missing == 0) return {};
    const double share = static_cast<double>(missing) / static_cast<double>(all);
    return Finding{{"UNDEF", evidence.subject,
                    fmt::format("{} of {} heights are undefined ({:.2g} %)", missing, all, 100.0 * share),
                    "crop ragged borders and fill small holes before transforms; statistics of heights use only the "
                    "defined heights"},
                   {effect("undefined_share", "", share, "1"), effect_count("undefined_heights", missing)}};
}

Found large_tilt(const Evidence& evidence) {
    const double before = evidence.form.rms_map, after = evidence.form.rms_level, tilt = removed_rms(before, after);
    if (!(tilt > large_tilt_ratio * after)) return {};
    const auto &map = evidence.map->heights, &level = evidence.heights.heights;
    FewRows plane(map.rows(), map.cols(), [&](Index i, double* row) {
        for (Index j = 0; j < map.cols(); ++j) row[j] = map(i, j) - level(i, j);
    });
    const auto pixel = evidence.map->pixel_size();
    const double along_x = slope_along(plane, pixel[0], true),
                 along_y = evidence.is_line ? 0.0 : slope_along(plane, pixel[1], false);
    const double slope = std::hypot(along_x, along_y);
    return Finding{
        {"TILT_LARGE", evidence.subject,
         fmt::format("the heights are tilted by {:.3g} ({:.3g} degrees): the rms height is {} with this tilt and {} "
                     "without it",
                     slope, std::atan(slope) * 180.0 / pi, length_text(before), length_text(after)),
         "subtract a plane (for a line: a straight line) before computing height parameters and spectra"},
        {effect("tilt", "", slope, "1"), effect("tilt_x", "", along_x, "1"), effect("tilt_y", "", along_y, "1"),
         effect("rms_height_as_measured", "h_rms", before, "m"),
         effect("rms_height_without_tilt", "h_rms", after, "m")}};
}

Found curvature_left(const Evidence& evidence) {
    if (!evidence.form.rms_without_parabola) return {};
    const double before = evidence.form.rms_level, after = *evidence.form.rms_without_parabola,
                 bow = removed_rms(before, after);
    if (!(bow > large_curvature_ratio * after)) return {};
    const auto [along_x, along_y] = curvatures_of_bowl(evidence);
    const double strongest = std::abs(along_x) > std::abs(along_y) ? along_x : along_y;
    return Finding{
        {"CURVATURE_LEFT", evidence.subject,
         fmt::format("the levelled surface is curved with a radius of {}: the rms height is {} with this curvature "
                     "and {} without it",
                     length_text(1.0 / std::abs(strongest)), length_text(before), length_text(after)),
         "subtract a parabola unless the form of the sample is what you study"},
        {effect("curvature_x", "", along_x, "1/m"), effect("curvature_y", "", along_y, "1/m"),
         effect("rms_height_with_curvature", "h_rms", before, "m"),
         effect("rms_height_without_curvature", "h_rms", after, "m")}};
}

}  // namespace setae::diagnostics
