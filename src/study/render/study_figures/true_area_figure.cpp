// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "drawing.hpp"
#include "setae/cache/key.hpp"
#include "setae/core/constants.hpp"
#include "setae/figures/typesetting.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/study_figures/true_area_of_maps.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;
using figures::Series;

constexpr std::uint64_t map_seed = 1;

template <class Formula>
Series formula_curve(const std::string& label, const Array1D& x, int colour, int dash, const Formula& formula) {
    return {.label = label, .x = x, .y = x.unaryExpr(formula), .mark = Mark::line, .colour = colour, .dash = dash};
}

std::string as_text(const std::vector<MeanArea>& areas) {
    std::string text;
    for (const auto& a : areas)
        text += fmt::format("{} {} {} {} {}\n", a.hurst_exponent, a.rms_slope, a.excess_area, a.deviation,
                            a.standard_error);
    return text;
}

std::vector<MeanArea> from_text(const std::string& text) {
    std::vector<MeanArea> areas;
    std::istringstream lines(text);
    MeanArea a;
    while (lines >> a.hurst_exponent >> a.rms_slope >> a.excess_area >> a.deviation >> a.standard_error)
        areas.push_back(a);
    return areas;
}

std::vector<MeanArea> areas_of_maps(const FigureRequest& request) {
    const Index map_points = request.options.area_map_points;
    const auto compute = [&] {
        return means(true_area_of_maps({.points = map_points, .seed = map_seed, .threads = request.options.threads}));
    };
    const auto* store = request.options.store;
    if (!store) return compute();
    const auto key = cache::KeyBuilder("true area of maps")
                         .add("points", fmt::format("{}", map_points))
                         .add("seed", fmt::format("{}", map_seed))
                         .key();
    if (const auto kept = store->find(key))
        if (auto areas = from_text(*kept); !areas.empty()) return areas;
    const auto areas = compute();
    store->keep(key, as_text(areas));
    return areas;
}

}  // namespace

void true_area(const FigureRequest& request, StudyFigure& drawn) {
    Panel factor{.title = "A",
                 .shows = "factor of small slopes",
                 .x = {.quantity = "rms slope *h*'_{rms}", .from = 0.0, .to = 5.0},
                 .y = {.quantity = "*g*(*h*'_{rms})", .from = 0.0, .to = 1.05}};
    factor.series.push_back(formula_curve("g of Eq. S12", Array1D::LinSpaced(101, 0.0, 5.0), colour::black, 0,
                                          [](double h) { return roughness::area_excess_factor(h); }));
    Panel area{
        .title = "B",
        .shows = "true area",
        .x = {.quantity = "rms slope *h*'_{rms}", .logarithmic = true, .from = 0.007, .to = 14.0},
        .y = {.quantity = "excess area *A*_{true}/*A*_{app} − 1", .logarithmic = true, .from = 1e-5, .to = 20.0}};
    const Array1D slopes = Array1D::LinSpaced(121, std::log(0.008), std::log(12.0)).exp();
    area.series.push_back(formula_curve("Eq. 9", slopes, colour::black, 0,
                                        [](double h) { return roughness::gaussian_area_ratio(h) - 1.0; }));
    area.series.push_back(formula_curve("h'²/2", slopes, colour::black, 2,
                                        [](double h) { return roughness::small_slope_area_ratio(h) - 1.0; }));
    const auto areas = areas_of_maps(request);
    double largest = 0.0;
    for (const auto& a : areas) largest = std::max(largest, std::abs(a.deviation));
    for (const double hurst : {0.3, 0.8}) {
        std::vector<double> x, y;
        for (const auto& a : areas)
            if (a.hurst_exponent == hurst) {
                x.push_back(a.rms_slope);
                y.push_back(a.excess_area);
            }
        area.series.push_back({.label = fmt::format("maps, H = {}", hurst),
                               .x = array_of(x),
                               .y = array_of(y),
                               .mark = Mark::points,
                               .colour = hurst < 0.5 ? colour::vermilion : colour::blue,
                               .symbol = hurst < 0.5 ? 1 : 0,
                               .hollow = hurst > 0.5});
    }
    drawn.figure = {.panels = {factor, area},
                    .columns = wide(request) ? 2 : 1,
                    .width_mm = wide(request) ? page_mm : column_mm,
                    .height_mm = wide(request) ? 72.0 : highest_column_mm};
    drawn.caption = fmt::format(
        "A: g of Eq. S12, the ratio of the excess area of Gaussian slopes to its small-slope limit: A_true/A_app = 1 + h'² g(h')/2. B: true area against rms "
        "slope: Eq. 9 for Gaussian slopes, its small-slope limit (Eq. S4), and the triangulated area (Eq. S3) of self-affine maps with H = 0.3 and 0.8, {} × {} points, "
        "three maps each, scaled to each slope; h' is the rms slope of the triangles. The maps agree with Eq. 9 to {} %. This figure does not depend on "
        "the study. Compare Fig. S7 of Dalvi et al. 2019.",
        request.options.area_map_points, request.options.area_map_points, figures::number_text(100.0 * largest, 2));
}

}  // namespace setae::study_figures
