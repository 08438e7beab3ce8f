// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study_figures/study_figures.hpp"

#include <filesystem>
#include <functional>

#include <fmt/format.h>

#include "builders.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/output/study_tables.hpp"

namespace setae::study_figures {
namespace {

using Build = std::function<void(const Sitting&, StudyFigure&)>;

/// A figure that a study may have.
struct Entry {
    std::string identifier, name, title;
    Build build;
};

/// A stem no other figure has.
std::string free_stem(std::string stem, std::size_t place, const std::vector<Entry>& entries) {
    // names that differ in other letters alone
    for (const auto& other : entries)
        if (other.name == stem) return stem + fmt::format("_{}", place + 1);
    return stem;
}

/// "loop:NAME" of every loop that was analysed, and how all of them depend on the range of their fit.
void add_loops(const study::StudyResult& result, std::vector<Entry>& entries) {
    for (std::size_t i = 0; i < result.experiments.size(); ++i) {
        if (!result.experiments[i].analysis) continue;
        const auto name = std::filesystem::path(result.experiments[i].input.file).stem().string();
        entries.push_back(
            {"loop:" + name, free_stem("loop_" + output::as_file_name(name), i, entries),
             "Force, contact radius and energy release rate of " + name,
             [i](const Sitting& sitting, StudyFigure& drawn) { loop_of(sitting.result.experiments[i], drawn); }});
    }
    entries.push_back({"ranges", "ranges", "E* and W of loading against the range of the fit", ranges_of_loops});
}

std::vector<Entry> entries_of(const study::StudyResult& result) {
    std::vector<Entry> entries{
        {"1", "figure_1", "Power spectral density of every surface", combined_spectra},
        {"2", "figure_2", "Contact radius and displacement against force", contact_of_one_elastomer},
        {"4", "figure_4", "Work of adhesion measured and predicted, and energy lost", prediction_and_loss},
        {"S1", "figure_S1", "A stylus scan of each surface", stylus_scans},
        {"S2", "figure_S2", "Power spectral density by technique", spectra_by_instrument},
        {"S3", "figure_S3", "Isotropic power spectral density", isotropic_spectra},
        {"S5", "figure_S5", "Contact radius against force on every elastomer", contact_radius_of_all},
        {"S6", "figure_S6", "Contact radius against force on the smooth reference", contact_radius_of_references},
        {"S7", "figure_S7", "True area against slope", true_area},
        {"S8", "figure_S8", "Work of adhesion measured and predicted by Persson and Tosatti's balance",
         persson_tosatti_prediction},
    };
    for (std::size_t i = 0; i < result.surfaces.size(); ++i) {
        if (result.surfaces[i].measurements.empty()) continue;
        const auto& name = result.surfaces[i].name;
        entries.push_back({"spectra:" + name, free_stem("spectra_" + output::as_file_name(name), i, entries),
                           "Every measurement of " + name, [i](const Sitting& sitting, StudyFigure& drawn) {
                               measured_spectra(sitting, sitting.result.surfaces[i], drawn);
                           }});
    }
    entries.push_back({"scales", "scales", "Which scales cost the energy", scales_of_cost});
    entries.push_back({"prediction", "prediction", "Work of adhesion measured and predicted against the modulus",
                       prediction_against_modulus});
    entries.push_back(
        {"replicates", "replicates", "Every replicate and the means of its surface", replicates_of_pairs});
    entries.push_back({"agreement", "agreement", "Measured over expected periodograms", agreement_of_instruments});
    add_loops(result, entries);
    return entries;
}

StudyFigure built(const Entry& entry, const Sitting& sitting) {
    StudyFigure drawn{.identifier = entry.identifier, .name = entry.name, .title = entry.title};
    try {
        entry.build(sitting, drawn);
    } catch (const Error& error) {
        drawn.reason = error.what();
    }
    if (!drawn.drawable()) drawn.figure = {};
    return drawn;
}

}  // namespace

std::vector<StudyFigure> study_figures(const study::StudyResult& result, const GalleryOptions& options) {
    const auto entries = entries_of(result);
    const Sitting sitting{result, options};
    std::vector<StudyFigure> figures;
    for (const auto& entry : entries) figures.push_back(built(entry, sitting));
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
