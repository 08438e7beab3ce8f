// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "drawing.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/figures/typesetting.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;
using study::StudyResult;

/// The elastomer on which most surfaces have a balance scale by scale, the stiffest of these.
const study::ElastomerResult* elastomer_with_scales(const StudyResult& result) {
    const study::ElastomerResult* best = nullptr;
    std::ptrdiff_t most = 0;
    for (const auto& elastomer : result.elastomers) {
        const auto n = std::count_if(result.pairs.begin(), result.pairs.end(), [&](const auto& pair) {
            return pair.scales && pair.elastomer == elastomer.input.name;
        });
        if (n > most || (n == most && n > 0 && elastomer.contact_modulus.value > best->contact_modulus.value)) {
            most = n;
            best = &elastomer;
        }
    }
    return best;
}

}  // namespace

void scales_of_cost(const FigureRequest& request, StudyFigure& drawn) {
    const auto& result = request.result;
    const auto* elastomer = elastomer_with_scales(result);
    if (!elastomer) {
        const auto& why = result.work_of_adhesion.reason;
        drawn.reason = result.pairs.empty() ? "the study has no pair of surface and elastomer"
                       : !why.empty()       ? why
                                            : "no pair has a balance scale by scale";
        return;
    }
    const figures::Axis q{.quantity = "wavevector *q*", .unit = "1/m", .logarithmic = true};
    const figures::Axis share_axis{.unit = "%", .from = 0.0, .to = 103.0};
    Panel energy{.title = "A", .shows = "stored energy", .x = q, .y = share_axis},
        area{.title = "B", .shows = "excess area", .x = q, .y = share_axis};
    Panel work{.title = "C", .shows = "work of adhesion", .x = q, .y = {.unit = "%"}};
    energy.y.quantity = "share of *U*_{el} below *q*";
    area.y.quantity = "share of excess area *A* below *q*";
    work.y.quantity = "share of Δ*W*_{app} below *q*";
    work.horizontal_lines = {0.0, 100.0};
    std::size_t n = 0;
    double lowest = HUGE_VAL, highest = 0.0;
    for (const auto& pair : result.pairs) {
        if (!pair.scales || pair.elastomer != elastomer->input.name) continue;
        ++n;
        const auto& scales = *pair.scales;
        const auto place = place_of_surface(result, pair.surface);
        const auto add = [&](Panel& panel, const Array1D& share) {
            panel.series.push_back({.label = pair.surface,
                                    .x = scales.wavevector,
                                    .y = 100.0 * share,
                                    .mark = Mark::line,
                                    .colour = colour_of_place(place),
                                    .symbol = static_cast<int>(place)});
        };
        add(energy, scales.stored_share);
        add(area, scales.area_share);
        add(work, scales.work_share);
        for (Index i = 0; i < scales.wavevector.size(); ++i)
            if (scales.stored_share[i] > 1e-3 || scales.area_share[i] > 1e-3)
                lowest = std::min(lowest, scales.wavevector[i]);
        highest = std::max(highest, scales.wavevector[scales.wavevector.size() - 1]);
    }
    for (auto* panel : {&energy, &area, &work})
        if (lowest < highest) {
            panel->x.from = lowest;
            panel->x.to = 1.3 * highest;
        }
    drawn.figure.panels = {energy, area, work};
    line_up(drawn.figure, request.options.width, 62.0);
    drawn.caption = fmt::format(
        "Contributions of scales: share from roughness with wavevectors below q, for {} on {}. A: stored energy U_el (Eq. 8), independent of the modulus. B: "
        "excess area A_true/A_app − 1 (Eq. 9), which increases with the slope. C: change ΔW_app = W_app − W_int of the full-contact balance (Eq. 7) on this elastomer, with W_int = {}. The share leaves the "
        "range 0 … 100 % if some scales increase and others decrease W_app.{}",
        counted(n, "surface"), elastomer->input.name, with_error(*result.work_of_adhesion, 1e3, "mJ/m2"),
        reconstruction_note(result) + floored_note(result));
}

void agreement_of_instruments(const FigureRequest& request, StudyFigure& drawn) {
    const auto& result = request.result;
    std::vector<const study::SurfaceResult*> fitted;
    for (const auto& surface : result.surfaces)
        if (!surface.failed() && surface.fitted && !surface.fitted->agreement.empty()) fitted.push_back(&surface);
    if (fitted.empty()) {
        drawn.reason = "no spectrum was fitted to the measurements of a surface by likelihood";
        return;
    }
    figures::Figure figure;
    double least = 0.8, most = 1.25;
    for (const auto* surface : fitted)
        for (const auto& a : surface->fitted->agreement) {
            // bars that reach towards 0 are cut
            least = std::min(least, 0.9 * std::max(a.ratio - a.standard_error, 0.5 * a.ratio));
            most = std::max(most, 1.1 * (a.ratio + a.standard_error));
        }
    const auto bands = instrument_bands(fitted);
    int lowest = 99, highest = -99;
    for (const auto* surface : fitted)
        for (const auto& a : surface->fitted->agreement) {
            lowest = std::min(lowest, a.decade);
            highest = std::max(highest, a.decade + 1);
        }
    std::vector<std::string> order;
    for (const auto& band : bands) order.push_back(band.instrument);
    for (const auto* surface : fitted) {
        Panel panel{.title = surface->name,
                    .x = {.quantity = "wavevector *q*",
                          .unit = "1/m",
                          .logarithmic = true,
                          .from = std::pow(10.0, lowest),
                          .to = std::pow(10.0, highest)},
                    .y = {.quantity = "measured/expected *P*/*E*", .logarithmic = true, .from = least, .to = most},
                    .horizontal_lines = {1.0}};
        std::map<std::string, std::vector<const spectral_fit::Agreement*>> by_instrument;
        for (const auto& a : surface->fitted->agreement) {
            by_instrument[instrument_in_words(a.instrument)].push_back(&a);
            if (std::find(order.begin(), order.end(), instrument_in_words(a.instrument)) == order.end())
                order.push_back(instrument_in_words(a.instrument));
        }
        for (const auto& instrument : order) {
            if (!by_instrument.contains(instrument)) continue;
            const auto& decades = by_instrument.at(instrument);
            const auto look = figures::instrument_look(instrument);
            std::vector<double> x, y, lower, upper;
            std::vector<std::string> names;
            for (const auto* a : decades) {
                x.push_back(std::pow(10.0, a->decade + 0.5));
                y.push_back(a->ratio);
                lower.push_back(a->ratio - a->standard_error);
                upper.push_back(a->ratio + a->standard_error);
                names.push_back(fmt::format("chi2 {} of {} groups, p = {}", figures::number_text(a->chi_squared, 3),
                                            a->groups, probability_text(a->probability)));
            }
            panel.series.push_back({.label = instrument,
                                    .x = array_of(x),
                                    .y = array_of(y),
                                    .lower = array_of(lower),
                                    .upper = array_of(upper),
                                    .mark = Mark::both,
                                    .colour = look.colour,
                                    .symbol = look.symbol,
                                    .names = names});
        }
        figure.panels.push_back(panel);
    }
    auto& explained = figure.panels.front();
    for (const auto& instrument : order) {
        const auto look = figures::instrument_look(instrument);
        if (std::none_of(explained.series.begin(), explained.series.end(),
                         [&](const auto& series) { return series.label == instrument; }))
            explained.series.push_back(
                {.label = instrument, .colour = look.colour, .symbol = look.symbol, .legend_only = true});
    }
    arrange(figure, request.options.width, 55.0);
    drawn.figure = figure;
    drawn.caption =
        "Ratio of measured to expected periodograms, by instrument and decade of q, weighted by degrees of freedom. The fitted spectrum gives the expected ones; the ratio is 1 if all instruments "
        "agree. Bars: one standard error of an instrument that agrees. Decades with only a few modes of an instrument scatter widely. The data of the figure contain χ², the groups of modes "
        "and the probability.";
}

}  // namespace setae::study_figures
