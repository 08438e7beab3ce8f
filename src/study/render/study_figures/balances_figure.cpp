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

constexpr std::array<NamedBalance, 7> balances{{{"modified", "(7)"},
                                                {"without_area_change", "(2)"},
                                                {"persson_tosatti", "(S13)"},
                                                {"strained_interface", "(7), χ fitted"},
                                                {"free_energies", "(7), U free"},
                                                {"partial_contact", "(7), partial"},
                                                {"reference_scaled", "(7), W_int by reference"}}};

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
    double best = all.front().score.log_likelihood, lowest = 0.0;
    for (const auto& row : all) best = std::max(best, row.score.log_likelihood);
    const double end = end_of_spectra(request.result);
    Panel cuts{.title = "A",
               .shows = "roughness below λ cut",
               .x = {.quantity = "every spectrum cut at *λ*", .unit = "m", .logarithmic = true},
               .y = {.quantity = "*R*²"}};
    Panel energies{.title = "B",
                   .shows = "γ₁ scaled",
                   .x = {.quantity = "*γ*₁ over that given"},
                   .y = {.quantity = "ln *L* below the best"}};
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
        "Which balance the {} pairs of work of adhesion speak for; W_int fitted anew for each point. A: share of the scatter explained, R², with the roughness below a wavelength "
        "cut from every spectrum, on the left none. B: logarithm of the likelihood below the best of all with γ1 of every elastomer scaled; 2 is what chance leaves open, and each further fitted "
        "parameter gains about half by chance. (7) asks for the stretched surface, (2) for nothing, (S13) is Persson and Tosatti's; χ is a change of the interface with stretch; "
        "with U_el free each surface has a stored energy of its own, which no spectrum can beat.",
        all.front().score.n);
}

}  // namespace setae::study_figures
