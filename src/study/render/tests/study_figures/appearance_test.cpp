// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <regex>
#include <set>

#include "setae/adhesion/prediction_test.hpp"
#include "setae/figures/instrument_look.hpp"
#include "setae/study_figures/write_figures.hpp"
#include "small_studies.hpp"

namespace setae::study_figures::appearance_test {
namespace {

using study::StudyResult;

/// Four surfaces seen by three instruments, four elastomers, pairs, loops and references: something for most figures.
StudyResult whole_study() {
    auto result = study_of_pairs();
    const Array1D q = Array1D::LinSpaced(400, 1e6, 1e8);
    result.surfaces.push_back(given_surface("third"));
    result.surfaces.push_back(given_surface("fourth"));
    for (auto& surface : result.surfaces) {
        surface.measurements = {measurement("map", "afm", q, 1e-6 * q.pow(-3.0), {2e6, 5e7}),
                                measurement("side", "tem", 10.0 * q, 1e-6 * q.pow(-3.0), {2e7, 9e8}),
                                measurement("line", "stylus", 0.01 * q, 1e-6 * q.pow(-3.0), {1e4, 9e5})};
        auto& scan = surface.measurements.back();
        scan.preview.positions = Array1D::LinSpaced(300, 0.0, 5e-4);
        scan.preview.heights = 1e-8 * (scan.preview.positions * 1e5).sin();
        scan.preview.size = {5e-4, 0.0};
        study::FittedSpectrum fitted;
        fitted.agreement = {{.instrument = "afm",
                             .decade = 6,
                             .ratio = 1.1,
                             .standard_error = 0.2,
                             .chi_squared = 12345678.0,
                             .groups = 4,
                             .probability = 4e-33},
                            {.instrument = "stylus", .decade = 5, .ratio = 0.9}};
        surface.fitted = fitted;
    }
    result.elastomers.push_back(elastomer("third", 3.000712e6));
    result.elastomers.push_back(elastomer("fourth", 5e6));
    result.study.elastomers.clear();
    for (const auto& e : result.elastomers) result.study.elastomers.push_back(e.input);
    for (const auto& e : result.elastomers) {
        result.experiments.push_back(jkr_experiment("smooth", e, 0.04));
        result.experiments.push_back(jkr_experiment("rough", e, 0.03));
        result.experiments.push_back(jkr_experiment("", e, 0.04));
        result.experiments.back().input.reference = true;
    }
    std::vector<adhesion::PredictionResidual> residuals;
    for (const auto& pair : result.pairs)
        residuals.push_back({pair.surface, pair.elastomer, *pair.approach, pair.modified->estimate});
    result.prediction_test =
        adhesion::prediction_test(residuals, Array2D((Eigen::MatrixXd::Identity(3, 3) * 1e-6).array()), std::nullopt);
    return result;
}

std::vector<StudyFigure> drawn_figures(FigureWidth width) {
    std::vector<StudyFigure> drawn;
    for (auto& figure : study_figures(whole_study(), {.width = width}))
        if (figure.drawable()) drawn.push_back(std::move(figure));
    return drawn;
}

TEST(Appearance, OfOneColumnIsAtMost120MillimetresHighWithOneLegend) {
    std::set<std::string> seen;
    for (const auto& drawn : drawn_figures(FigureWidth::single_column)) {
        seen.insert(drawn.identifier);
        EXPECT_LE(drawn.figure.height_mm, 120.0 + 1e-9) << drawn.identifier;
        EXPECT_NO_THROW((void)figures::gnuplot_script(drawn.figure, "svg", "a.svg")) << drawn.identifier;
        // no two legends of a figure name the same
        std::set<std::string> named;
        for (const auto& panel : drawn.figure.panels) {
            if (!panel.legend) continue;
            std::set<std::string> own;
            for (const auto& series : panel.series)
                if (series.in_legend && !series.label.empty()) own.insert(series.label);
            for (const auto& label : own) EXPECT_TRUE(named.insert(label).second) << drawn.identifier << ": " << label;
        }
    }
    for (const char* wanted : {"1", "2", "4", "S1", "S2", "S5", "S6", "prediction", "agreement"})
        EXPECT_TRUE(seen.contains(wanted)) << wanted;
}

TEST(Appearance, HasOneColourPerInstrumentInEveryFigure) {
    std::map<std::string, std::set<int>> colours;
    for (const auto& drawn : drawn_figures(FigureWidth::double_column))
        for (const auto& panel : drawn.figure.panels)
            for (const auto& series : panel.series)
                for (const char* instrument : {"stylus", "AFM", "TEM"})
                    if (series.label.ends_with(instrument)) colours[instrument].insert(series.colour);
    ASSERT_EQ(colours.size(), 3u);
    std::set<int> all;
    for (const auto& [instrument, own] : colours) {
        EXPECT_EQ(own, std::set<int>{figures::instrument_look(instrument).colour}) << instrument;
        all.insert(own.begin(), own.end());
    }
    EXPECT_EQ(all.size(), 3u);
    // and no surface or elastomer has it
    for (const auto& drawn : drawn_figures(FigureWidth::double_column))
        for (const auto& panel : drawn.figure.panels)
            for (const auto& series : panel.series)
                if (series.label == "smooth" || series.label == "soft") {
                    EXPECT_LT(series.colour, figures::general_colours);
                }
}

TEST(Appearance, HasNoMarkupInFilesOfNumbers) {
    const std::regex markup(R"(<su[bp]>|\{|\}|\^\{|/Symbol|\*[A-Za-z]\*)");
    for (const auto& drawn : drawn_figures(FigureWidth::double_column)) {
        const auto data = data_of(drawn, "study.toml");
        std::smatch found;
        EXPECT_FALSE(std::regex_search(data, found, markup)) << drawn.identifier << ": " << found.str();
    }
}

TEST(Appearance, HasPowersOfTenInsteadOfE) {
    const std::regex number(R"([0-9]e[-+]?[0-9])");
    const auto look = [&](const std::string& where, const std::string& text) {
        EXPECT_FALSE(std::regex_search(text, number)) << where << ": " << text;
    };
    bool probability = false;
    for (const auto& drawn : drawn_figures(FigureWidth::double_column)) {
        look(drawn.identifier, drawn.title);
        look(drawn.identifier, drawn.caption);
        for (const auto& panel : drawn.figure.panels) {
            look(drawn.identifier, panel.title + " " + panel.shows);
            for (const auto& note : panel.notes) {
                look(drawn.identifier, note.text);
                probability = probability || note.text.find("·10⁻") != std::string::npos;
            }
            for (const auto& series : panel.series) {
                look(drawn.identifier, series.label);
                for (const auto& name : series.names) look(drawn.identifier, name);
            }
        }
    }
    EXPECT_TRUE(probability);
}

TEST(Appearance, NamesEveryPanelOfSeveral) {
    for (const auto width : {FigureWidth::single_column, FigureWidth::double_column})
        for (const auto& drawn : drawn_figures(width)) {
            std::set<std::string> letters;
            std::size_t headed = 0;
            for (std::size_t p = 0; p < drawn.figure.panels.size(); ++p) {
                const auto heading = figures::heading_of(drawn.figure, p);
                if (heading.letter.empty()) continue;
                ++headed;
                EXPECT_FALSE(heading.words.empty()) << drawn.identifier << " " << heading.letter;
                letters.insert(heading.letter);
            }
            EXPECT_EQ(letters.size(), headed) << drawn.identifier;
            // residuals below a panel belong to it
            const std::size_t panels = drawn.figure.panels.size();
            if (panels > 1 && drawn.identifier != "4" && drawn.identifier != "S8") {
                EXPECT_EQ(headed, panels) << drawn.identifier;
            }
        }
}

TEST(Appearance, TitlesHaveRoundedModuli) {
    const auto drawn = study_figure(whole_study(), "S5");
    ASSERT_EQ(drawn.figure.panels.size(), 4u);
    EXPECT_EQ(drawn.figure.panels[2].title, "third, 3 MPa");
}

TEST(Appearance, SpectraEndBeforeTheEndOfTheirData) {
    StudyResult result;
    auto surface = given_surface("published");
    const Array1D q = Array1D::LinSpaced(200, std::log(1e5), std::log(1e9)).exp();
    surface.average.curve = {q, 1e-3 * q.pow(-3.6), {1e5, 1e9}, spectra::Density::C_iso};
    result.surfaces = {surface};
    const auto first = study_figure(result, "1");
    const auto& curve = series_of(first.figure.panels[0], "published");
    const Index last = curve.x.size() - 1;
    EXPECT_LE(curve.x[last], 0.7e9);
    EXPECT_GT(curve.x[last], 0.6e9);
    // −2.6 without an end; a plunge is far steeper
    EXPECT_GT(std::log(curve.y[last] / curve.y[last - 1]) / std::log(curve.x[last] / curve.x[last - 1]), -4.5);
    for (const auto& drawn : drawn_figures(FigureWidth::double_column)) {
        if (drawn.identifier != "S2") continue;
        for (const auto& panel : drawn.figure.panels)
            for (const auto& series : panel.series)
                if (series.label.ends_with("AFM") && series.x.size() > 0) {
                    EXPECT_LE(series.x[series.x.size() - 1], 1.15 * 5e7);  // bins are ten a decade
                }
    }
}

}  // namespace
}  // namespace setae::study_figures::appearance_test
