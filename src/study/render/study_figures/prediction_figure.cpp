// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "drawing.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/figures/typesetting.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;
using study::PairResult;
using study::StudyResult;

/// Measured pairs on a surface with a prediction by the full-contact balance (Eq. 7).
std::vector<const PairResult*> pairs_on(const StudyResult& result, const std::string& surface) {
    std::vector<const PairResult*> pairs;
    for (const auto& pair : result.pairs)
        if (pair.surface == surface && pair.modified) pairs.push_back(&pair);
    return pairs;
}

const adhesion::PredictionResidual* residual_of(const StudyResult& result, const PairResult& pair) {
    if (!result.prediction_test) return nullptr;
    for (const auto& residual : result.prediction_test->pairs)
        if (residual.surface == pair.surface && residual.elastomer == pair.elastomer) return &residual;
    return nullptr;
}

/// The mean γ1 of the elastomers, and whether they differ.
struct CommonSurfaceEnergy {
    TracedValue mean;
    bool differ = false;
};

CommonSurfaceEnergy surface_energy_of(const StudyResult& result) {
    CommonSurfaceEnergy common;
    const double share = 1.0 / static_cast<double>(result.elastomers.size());
    for (const auto& elastomer : result.elastomers) {
        const auto own = elastomer.soft_side().surface_energy;
        common.mean = {common.mean.value + share * own.value,
                       combined({{1.0, common.mean.components}, {share, own.components}})};
        common.differ =
            common.differ || std::abs(own.value - result.elastomers.front().input.surface_energy.value) > 1e-9;
    }
    return common;
}

/// Contact moduli [Pa] from half the least to twice the largest.
Array1D moduli_of(const StudyResult& result) {
    double least = HUGE_VAL, most = 0.0;
    for (const auto& elastomer : result.elastomers) {
        if (!(elastomer.contact_modulus.value > 0.0)) continue;
        least = std::min(least, elastomer.contact_modulus.value);
        most = std::max(most, elastomer.contact_modulus.value);
    }
    return Array1D::LinSpaced(121, std::log(0.5 * least), std::log(2.0 * most)).exp();
}

void add_measured(Panel& panel, const StudyResult& result, const PairResult& pair) {
    const auto& modulus = result.elastomer(pair.elastomer).contact_modulus;
    const auto& measured = *pair.approach;
    const double modulus_error = std::sqrt(modulus.variance()), work_error = std::sqrt(measured.variance());
    const auto* residual = residual_of(result, pair);
    const auto place = place_of_elastomer(result, pair.elastomer);
    const double x = MPa * modulus.value, y = mJ * measured.value;
    panel.series.push_back(
        {.label = pair.elastomer,
         .x = Array1D::Constant(1, x),
         .y = Array1D::Constant(1, y),
         .lower = Array1D::Constant(1, y - mJ * work_error),
         .upper = Array1D::Constant(1, y + mJ * work_error),
         .mark = Mark::points,
         .colour = colour_of_place(place),
         .symbol = static_cast<int>(place),
         .left = Array1D::Constant(1, x - MPa * modulus_error),
         .right = Array1D::Constant(1, x + MPa * modulus_error),
         .in_legend = false,
         .names = {
             fmt::format("{}: measured {}, predicted {} mJ/m2{}", pair.elastomer, with_error(measured, mJ, "mJ/m2"),
                         figures::number_text(mJ * pair.modified->work.floored, 4),
                         residual ? fmt::format(", {:+.2f} standard errors apart", residual->standardised()) : "")}});
}

/// A pair that was not measured: only its prediction, hollow.
void add_predicted(Panel& panel, const StudyResult& result, const PairResult& pair) {
    const auto& modulus = result.elastomer(pair.elastomer).contact_modulus;
    const auto place = place_of_elastomer(result, pair.elastomer);
    panel.series.push_back({.label = pair.elastomer + ", not measured",
                            .x = Array1D::Constant(1, MPa * modulus.value),
                            .y = Array1D::Constant(1, mJ * pair.modified->work.floored),
                            .mark = Mark::points,
                            .colour = colour_of_place(place),
                            .symbol = static_cast<int>(place),
                            .hollow = true,
                            .in_legend = false,
                            .names = {fmt::format("{}: predicted {}, not measured", pair.elastomer,
                                                  with_error(pair.modified->estimate, mJ, "mJ/m2"))}});
}

/// "+3.9 σ": measured minus predicted in standard errors.
std::string deviation_in_words(double apart) {
    const auto size = fmt::format("{:.1f} σ", std::abs(apart));
    return (size.starts_with("0.0") ? "" : apart < 0.0 ? "−" : "+") + size;
}

constexpr double row_share = 0.075;  ///< share of an axis' range: height of a row of text

/// Measured minus predicted in standard errors, below the data; a second row for neighbours that would overlap.
void add_residuals(Panel& panel, const StudyResult& result, const std::vector<const PairResult*>& pairs,
                   double lowest) {
    constexpr double min_distance = 0.14;  // share of the width
    const double whole = std::log(*panel.x.to / *panel.x.from);
    std::vector<std::pair<double, std::string>> texts;
    for (const auto* pair : pairs)
        if (const auto* residual = pair->approach ? residual_of(result, *pair) : nullptr)
            texts.emplace_back(MPa * result.elastomer(pair->elastomer).contact_modulus.value,
                               deviation_in_words(residual->standardised()));
    std::sort(texts.begin(), texts.end());
    double last = -HUGE_VAL;
    bool second = false;
    for (const auto& [modulus, text] : texts) {
        const double at = std::log(modulus) / whole;
        second = at - last < min_distance && !second;
        last = at;
        const double below = (second ? 2.0 : 1.0) * row_share * (*panel.y.to - *panel.y.from);
        panel.notes.push_back({.text = text, .x = modulus, .y = lowest - below});
    }
}

/// χ² in the upper left corner, above all values; on a page the scatter of the model below it, for which a column has
/// no space.
void add_test(Panel& panel, const adhesion::PredictionTest& test, bool page) {
    const double step = (page ? row_share : 0.13) * (*panel.y.to - *panel.y.from);
    double height = *panel.y.to;
    const auto write = [&](const std::string& text) {
        panel.notes.push_back({.text = text,
                               .x = *panel.x.from * std::pow(*panel.x.to / *panel.x.from, 0.02),  // next to the ticks
                               .y = height -= step,
                               .side = figures::Note::Side::right});
    };
    write(fmt::format("χ² = {:.1f}, {} degrees of freedom, p = {}", test.chi_squared, test.degrees_of_freedom,
                      probability_text(test.probability)));
    if (page && test.extra_scatter > 0.0)
        write(fmt::format("scatter of the model: {:.1f} mJ/m²", mJ * test.extra_scatter));
}

std::string test_in_words(const adhesion::PredictionTest& test) {
    auto text = fmt::format(
        "Measured minus predicted over {3} gives χ² = {0:.1f} for {1} degrees of freedom (p = {2}), with both errors and the errors that pairs share",
        test.chi_squared, test.degrees_of_freedom, probability_text(test.probability),
        counted(static_cast<std::size_t>(test.n), "pair"));
    if (test.work_fitted) text += "; W_int is fitted to these pairs";
    if (test.extra_scatter > 0.0)
        text += fmt::format("; with an additional scatter of the model of {} mJ/m2, χ² = {:.1f} (p = {})",
                            figures::number_text(mJ * test.extra_scatter, 2), test.chi_squared_with_scatter,
                            probability_text(test.probability_with_scatter));
    if (!test.left_out.empty()) text += fmt::format("; left out: {}", fmt::join(test.left_out, ", "));
    return text;
}

}  // namespace

void prediction_against_modulus(const FigureRequest& request, StudyFigure& drawn) {
    const auto& result = request.result;
    std::vector<const study::SurfaceResult*> surfaces;
    for (const auto& surface : result.surfaces)
        if (!surface.failed() && !pairs_on(result, surface.name).empty()) surfaces.push_back(&surface);
    if (surfaces.empty()) {
        const auto& why = result.work_of_adhesion.reason;
        drawn.reason = result.pairs.empty() ? "the study has no pair of surface and elastomer"
                       : !why.empty()       ? why
                                            : "no pair has a prediction";
        return;
    }
    const auto energy = surface_energy_of(result);
    const auto moduli = moduli_of(result);
    figures::Figure figure;
    double highest = 0.0, lowest = 0.0;
    for (const auto* surface : surfaces) {
        Panel panel{.title = label_of(*surface),
                    .x = {.quantity = "contact modulus *E*\\*",
                          .unit = "MPa",
                          .logarithmic = true,
                          .from = MPa * moduli[0],
                          .to = MPa * moduli[moduli.size() - 1]},
                    .y = {.quantity = "work of adhesion *W*_app", .unit = "mJ/m2"},
                    .horizontal_lines = {0.0}};
        const auto curve =
            adhesion::prediction_curve({surface->name, surface->used().parameters, surface->used().spread}, energy.mean,
                                       result.traced_work_of_adhesion, moduli);
        panel.series.push_back({.label = "Eq. 7, 95 % band",
                                .x = MPa * curve.contact_modulus,
                                .y = mJ * curve.work_of_adhesion,
                                .lower = mJ * curve.lower,
                                .upper = mJ * curve.upper,
                                .mark = Mark::band,
                                .colour = colour::black,
                                .dash = 0});
        highest = std::max(highest, mJ * curve.work_of_adhesion.maxCoeff());
        for (const auto* pair : pairs_on(result, surface->name)) {
            if (!pair->approach) {
                add_predicted(panel, result, *pair);
                continue;
            }
            add_measured(panel, result, *pair);
            const double error = std::sqrt(pair->approach->variance());
            highest = std::max(highest, mJ * (pair->approach->value + error));
            lowest = std::min(lowest, mJ * (pair->approach->value - error));
        }
        if (figure.panels.empty()) {
            for (std::size_t e = 0; e < result.elastomers.size(); ++e)
                panel.series.push_back({.label = result.elastomers[e].input.name,
                                        .mark = Mark::points,
                                        .colour = colour_of_place(e),
                                        .symbol = static_cast<int>(e),
                                        .legend_only = true});
        }
        figure.panels.push_back(std::move(panel));
    }
    // bands of surfaces with almost no contact may extend far beyond: they are cut at the axis. Panels of a page have
    // the difference of measured and predicted in a row below the data, for which a column is too narrow
    const bool page = wide(request);
    const double extent = highest - lowest, below = page ? 0.36 : 0.08;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        auto& panel = figure.panels[p];
        panel.y.from = lowest - below * extent;
        panel.y.to = highest + (result.prediction_test ? 0.35 : 0.08) * extent;
        if (page) add_residuals(panel, result, pairs_on(result, surfaces[p]->name), lowest);
    }
    if (result.prediction_test) add_test(figure.panels.front(), *result.prediction_test, page);
    arrange(figure, request.options.width, 66.0);
    drawn.figure = figure;
    drawn.caption = fmt::format(
        "Work of adhesion on approach against the contact modulus, for each surface: measured, and predicted by the full-contact balance (Eq. 7) with W_int = {} ({}). Line: prediction, at least 0; shaded: 95 % band "
        "from the errors of spectrum, surface energy and W_int. {}Bars: one standard error of measured work and modulus; {} measured minus predicted, in standard errors of both{}. {}.{}{}",
        with_error(*result.work_of_adhesion, mJ, "mJ/m2"), result.work_of_adhesion_source,
        std::any_of(result.pairs.begin(), result.pairs.end(),
                    [](const auto& pair) { return pair.modified && !pair.approach; })
            ? "Hollow: predicted, not measured. "
            : "",
        page ? "numbers below the data:" : "the file of numbers contains",
        result.study.work_of_adhesion ? "" : " without the error of the fitted W_int",
        result.prediction_test ? test_in_words(*result.prediction_test) : "No χ²: " + result.prediction_test.reason,
        energy.differ ? fmt::format(" Elastomers have different surface energies: curves are drawn at their mean, {}.",
                                    with_error(energy.mean.estimate(), mJ, "mJ/m2"))
                      : "",
        reconstruction_note(result));
}

}  // namespace setae::study_figures
