// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "drawing.hpp"
#include "setae/core/constants.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;

struct NamedBalance {
    const char* balance;
    const char* label;
};

constexpr std::array<NamedBalance, 7> balances{{{"modified", "Eq. 7"},
                                                {"without_area_change", "Eq. 2"},
                                                {"persson_tosatti", "Eq. S13"},
                                                {"strained_interface", "Eq. 7, χ fitted"},
                                                {"free_energies", "Eq. 7, U free"},
                                                {"partial_contact", "Eq. 7, partial"},
                                                {"reference_scaled", "Eq. 7, reference W_int"}}};

/// One balance along a choice, in the order of that choice.
template <class ChoiceOf, class ValueOf>
void add_series(Panel& panel, std::vector<study::ComparedBalance> rows, std::size_t place, ChoiceOf choice,
                ValueOf value) {
    std::sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return choice(a) < choice(b); });
    std::vector<double> x, y;
    for (const auto& row : rows) {
        x.push_back(choice(row));
        y.push_back(value(row));
    }
    panel.series.push_back({.label = balances[place].label,
                            .x = array_of(x),
                            .y = array_of(y),
                            .mark = Mark::both,
                            .colour = colour_of_place(place),
                            .symbol = static_cast<int>(place)});
}

/// Where the spectrum that reaches least far ends [m].
double end_of_spectra(const study::StudyResult& result) {
    double end = 0.0;
    for (const auto& surface : result.surfaces)
        if (!surface.failed()) end = std::max(end, 2.0 * pi / surface.used().curve.band.upper);
    return end;
}

}  // namespace

void comparison_of_balances(const FigureRequest& request, StudyFigure& drawn) {
    const auto& all = request.result.balances;
    if (all.empty()) {
        drawn.reason = "no pairs with a measured work of adhesion and a predictable surface";
        return;
    }
    const auto pairs = static_cast<std::size_t>(all.front().score.n);
    if (pairs < min_compared_pairs) {
        drawn.reason = fmt::format("{} with a measured work of adhesion; a comparison of balances needs at least {}",
                                   counted(pairs, "pair"), min_compared_pairs);
        return;
    }
    double best = all.front().score.log_likelihood, lowest = 0.0;
    for (const auto& row : all) best = std::max(best, row.score.log_likelihood);
    const double end = end_of_spectra(request.result);
    Panel cuts{.title = "A",
               .shows = "roughness below λ cut",
               .x = {.quantity = "short cutoff *λ*", .unit = "m", .logarithmic = true},
               .y = {.quantity = "*R*²"}};
    Panel energies{.title = "B",
                   .shows = "γ₁ scaled",
                   .x = {.quantity = "*γ*₁ over its given value"},
                   .y = {.quantity = "ln *L* minus that of the best"}};
    for (std::size_t place = 0; place < balances.size(); ++place) {
        std::vector<study::ComparedBalance> over_cuts, over_energies;
        for (const auto& row : all) {
            if (row.balance != balances[place].balance) continue;
            if (row.surface_energy_factor == 1.0) over_cuts.push_back(row);
            if (row.shortest_wavelength == 0.0) over_energies.push_back(row);
        }
        if (!over_cuts.empty())
            add_series(
                cuts, over_cuts, place, [end](const auto& row) { return std::max(end, row.shortest_wavelength); },
                [&](const auto& row) {
                    lowest = std::min(lowest, row.score.r_squared);
                    return row.score.r_squared;
                });
        if (!over_energies.empty())
            add_series(
                energies, over_energies, place, [](const auto& row) { return row.surface_energy_factor; },
                [&](const auto& row) { return row.score.log_likelihood - best; });
    }
    cuts.y.from = std::max(-1.0, lowest - 0.05);  // worse than no model at all
    cuts.y.to = 1.02;
    std::vector<Panel> panels;
    for (auto& panel : {cuts, energies})
        if (!panel.series.empty()) panels.push_back(panel);
    drawn.figure.panels = panels;
    arrange(drawn.figure, request.options.width, 62.0);
    drawn.caption = fmt::format(
        "Comparison of balances for {} with a measured work of adhesion; every point has its own fitted W_int. A: R² with the roughness below the wavelength λ removed from every spectrum; the first points are without cut. "
        "B: logarithm of the likelihood minus that of the best balance, with γ1 of every elastomer scaled. A difference of 2 is within chance, and each additional fitted parameter gains about one half by chance. "
        "Eq. 7 is the full-contact balance, Eq. 2 the small-slope balance without stretching of the soft surface, and Eq. S13 the Persson–Tosatti balance. χ: the interface energy changes with stretch. "
        "U free: the stored energy of each surface is fitted, an upper limit for every spectrum.",
        counted(pairs, "pair"));
}

}  // namespace setae::study_figures
