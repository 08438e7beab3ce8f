// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study_figures/study_figures.hpp"

#include <cctype>
#include <filesystem>
#include <functional>

#include <fmt/format.h>

#include "builders.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/output/file_names.hpp"
#include "setae/study_figures/figure_kinds.hpp"

namespace setae::study_figures {
namespace {

/// A figure that a study may have.
struct Entry {
    std::string identifier, name, title;
    std::function<void(const FigureRequest&, StudyFigure&)> build;
};

/// Item of one figure of a kind.
struct Named {
    std::string name;
    std::function<void(const FigureRequest&, StudyFigure&)> build;
};

/// Adds a figure "spectra:NAME" for each item of a kind, with its file named after the item.
void add_named(const FigureKind& kind, const std::vector<Named>& things, std::vector<Entry>& entries) {
    std::vector<std::string> names;
    for (const auto& thing : things) names.push_back(thing.name);
    const auto stems = output::file_names(names);
    const auto prefix = kind.identifier.substr(0, kind.identifier.find(':')) + "_";
    for (std::size_t i = 0; i < things.size(); ++i) {
        const auto named = [&](std::string text) { return text.replace(text.find("NAME"), 4, names[i]); };
        entries.push_back({named(kind.identifier), prefix + stems[i], named(kind.title), things[i].build});
    }
}

/// "spectra:NAME" of every surface with measurements.
void add_surfaces(const FigureKind& kind, const study::StudyResult& result, std::vector<Entry>& entries) {
    std::vector<Named> things;
    for (std::size_t i = 0; i < result.surfaces.size(); ++i)
        if (!result.surfaces[i].measurements.empty())
            things.push_back({result.surfaces[i].name, [i](const FigureRequest& request, StudyFigure& drawn) {
                                  measured_spectra(request, request.result.surfaces[i], drawn);
                              }});
    add_named(kind, things, entries);
}

/// "loop:NAME" of every loop that was analysed.
void add_loops(const FigureKind& kind, const study::StudyResult& result, std::vector<Entry>& entries) {
    std::vector<Named> things;
    for (std::size_t i = 0; i < result.experiments.size(); ++i)
        if (result.experiments[i].analysis)
            things.push_back({std::filesystem::path(result.experiments[i].input.file).stem().string(),
                              [i](const FigureRequest& request, StudyFigure& drawn) {
                                  loop_of(request.result.experiments[i], request.options.width, drawn);
                              }});
    add_named(kind, things, entries);
}

/// A kind of figure and its function: one per study, or several.
struct Kind {
    FigureKind shown;
    void (*build)(const FigureRequest&, StudyFigure&) = nullptr;
    void (*add)(const FigureKind&, const study::StudyResult&, std::vector<Entry>&) = nullptr;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> list{
        {{"1", "Power spectral density of every surface",
          "C1D against q of all surfaces with 95 % bands; bars: reliable band of each instrument; in two columns also an AFM map "
          "and a TEM contour",
          "the spectrum used for each surface"},
         combined_spectra},
        {{"2", "Contact radius and displacement against force",
          "A contact radius against force, loading hollow, unloading filled, Eq. 1 dashed; B force against displacement, the "
          "loop with the largest loss shaded",
          "loops on the elastomer nearest to 1.9 MPa"},
         contact_of_one_elastomer},
        {{"4", "Measured and predicted work of adhesion, and energy loss",
          "A measured against predicted W_app (Eq. 7), line y = x; B E_loss against A_true, line through the origin (Eq. 10); "
          "residuals below each",
          "pairs with measured values"},
         prediction_and_loss},
        {{"S1", "A stylus scan of each surface", "the longest stylus scan of each surface, trend removed",
          "measurements"},
         stylus_scans},
        {{"S2", "Power spectral density by technique",
          "C1D by technique, each within its reliable band; one panel per surface", "measurements"},
         spectra_by_instrument},
        {{"S3", "Isotropic power spectral density",
          "C_iso against q; averages are converted by Eq. 11 or by the inverse Abel integral, as the study states",
          "as 1"},
         isotropic_spectra},
        {{"S5", "Contact radius against force on every elastomer",
          "figure 2A for every elastomer; solid: Eq. S2 through the last points before pull-off", "loops"},
         contact_radius_of_all},
        {{"S6", "Contact radius against force on the smooth reference",
          "contact radius against force on the smooth reference, Eq. 1 fitted to both branches", "reference loops"},
         contact_radius_of_references},
        {{"S8", "Measured work of adhesion and prediction of the Persson–Tosatti balance",
          "figure 4A with Eq. S13 and its own fitted W_int", "as 4"},
         persson_tosatti_prediction},
        {{"spectra:NAME", "Every measurement of NAME",
          "every measurement of a surface: solid where reliable, pale and dotted where cut; black: their fit or average",
          "measurements; one figure per surface"},
         nullptr,
         add_surfaces},
        {{"scales", "Contributions of scales to energy and area",
          "shares of U_el, excess area and change of W_app below q", "pairs on the stiffest elastomer"},
         scales_of_cost},
        {{"prediction", "Measured and predicted work of adhesion against the modulus",
          "W_app by Eq. 7 against E* for each surface with its 95 % band; measured values with bars of W and E*; in two columns "
          "also measured minus predicted in standard errors of both; χ² of all pairs",
          "pairs with a prediction"},
         prediction_against_modulus},
        {{"hysteresis", "Work of adhesion on retraction: measured against predicted from roughness",
          "measured against predicted W_ret at pull-off, by the most likely model with a smooth limit; symbol by surface, colour by elastomer, hollow where "
          "contact is partial",
          "pairs with a measured W_ret at pull-off"},
         way_back},
        {{"losses", "Energy budget of loops",
          "one bar per pair: jumps of the sphere, crack tip, roughness; symbols: measured E_loss",
          "pairs with measured works on both branches, else sphere_radius and preload"},
         shares_of_losses},
        {{"budget", "Contributions to the ± of W_int",
          "share of the variance of W_int by input, the largest first; beside each bar the ± if that input's ± is halved",
          "a W_int with ±"},
         budget_of_work},
        {{"balances", "Comparison of energy balances",
          "R² of every balance against the short cutoff of the spectra; ln L of every balance against γ1",
          "pairs with a measured work of adhesion"},
         comparison_of_balances},
        {{"replicates", "Every replicate and the means of its surface",
          "W_app of every loop with the 95 % interval of its fit, by lens and spot; diamonds: means by "
          "the mixed model; hollow: excluded, with the reason",
          "loops that name a lens, a spot or an exclusion"},
         replicates_of_pairs},
        {{"agreement", "Ratio of measured to expected periodograms",
          "measured over expected periodograms by instrument and decade, with the standard error of an instrument that agrees",
          "surfaces fitted by likelihood"},
         agreement_of_instruments},
        {{"loop:NAME", "Force, contact radius and energy release rate of NAME",
          "force against displacement with the closed loop shaded, contact radius against force, G against contact radius, "
          "the fits dashed",
          "loops; one figure per loop"},
         nullptr,
         add_loops},
        {{"ranges", "E* and W of loading against the range of the fit",
          "E* and W of loading against the start and the end of the fitted range, and W against E*",
          "up to seven loops"},
         ranges_of_loops}};
    return list;
}

std::vector<Entry> entries_of(const study::StudyResult& result,
                              std::size_t max_of_a_kind = std::numeric_limits<std::size_t>::max()) {
    std::vector<Entry> entries;
    for (const auto& [shown, build, add] : kinds()) {
        if (add) {
            const auto before = entries.size();
            add(shown, result, entries);
            if (entries.size() - before > max_of_a_kind) entries.resize(before + max_of_a_kind);
        } else
            entries.push_back({shown.identifier,
                               (std::islower(shown.identifier[0]) ? "" : "figure_") + shown.identifier, shown.title,
                               build});
    }
    return entries;
}

StudyFigure built(const Entry& entry, const FigureRequest& request) {
    StudyFigure drawn{.identifier = entry.identifier, .name = entry.name, .title = entry.title};
    try {
        entry.build(request, drawn);
    } catch (const std::exception& error) {
        drawn.reason = reason_of(error);
    }
    if (!drawn.drawable()) drawn.figure = {};
    return drawn;
}

}  // namespace

std::vector<FigureKind> figure_kinds() {
    std::vector<FigureKind> list;
    for (const auto& kind : kinds()) list.push_back(kind.shown);
    return list;
}

std::vector<StudyFigure> study_figures(const study::StudyResult& result, const GalleryOptions& options) {
    const auto entries = entries_of(result, options.max_of_a_kind);
    const FigureRequest request{result, options};
    std::vector<StudyFigure> figures;
    for (const auto& entry : entries) figures.push_back(built(entry, request));
    return figures;
}

StudyFigure study_figure(const study::StudyResult& result, const std::string& identifier,
                         const GalleryOptions& options) {
    std::vector<std::string> identifiers;
    for (const auto& entry : entries_of(result)) {
        if (entry.identifier == identifier) return built(entry, {result, options});
        identifiers.push_back(entry.identifier);
    }
    const auto nearest = nearest_match(identifier, identifiers);
    throw InvalidArgument(fmt::format("unknown figure '{}'{}; this study has {}", identifier,
                                      nearest.empty() ? "" : "; did you mean '" + nearest + "'?",
                                      fmt::join(identifiers, ", ")));
}

}  // namespace setae::study_figures
