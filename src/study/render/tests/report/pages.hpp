// SPDX-License-Identifier: GPL-3.0-or-later
// Studies and figures the tests of reports look at.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "setae/core/constants.hpp"
#include "setae/study/study_result.hpp"
#include "setae/study_figures/study_figures.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tests {

inline constexpr const char* hostile_name = "</script><script>alert(1)</script>\"'&~/";

/// A folder that goes when the test ends.
class Folder {
public:
    explicit Folder(const std::string& name)
        : path_(std::filesystem::temp_directory_path() / ("setae_report_" + name + "_" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

    /// A line of 200 µm with one cosine of 5 µm wavelength.
    void write_scan(const std::string& name, double amplitude) const {
        const Array1D x = Array1D::LinSpaced(1000, 0.0, 199.8e-6);
        tables::write_csv(file(name), {{{"x", "m", x}, {"h", "m", amplitude * (2.0 * pi * x / 5e-6).cos()}}, {}});
    }

    /// The study of a text in TOML, run here.
    [[nodiscard]] study::StudyResult run(const std::string& toml) const {
        std::ofstream(file("study.toml"))
            << "title = \"A study\"\n[rough_solid]\nyoungs_modulus = \"1e9 GPa\"\npoisson_ratio = 0.0\n"
               "[analysis]\nspectrum = \"average\"\nwindow = \"none\"\nbootstrap_resamples = 0\n"
            << toml;
        return study::run_study(study::read_study(file("study.toml")));
    }

private:
    std::filesystem::path path_;
};

/// Loops of two lenses on a surface, one excluded, every name hostile.
inline study::ElastomerReplicates sample_replicates(const std::string& surface, const std::string& elastomer) {
    study::ElastomerReplicates replicates{.elastomer = elastomer, .symbol = "W_app"};
    replicates.data.quantity = "work_of_adhesion_approach";
    replicates.data.unit = "J/m2";
    replicates.data.rows = {{0.038, 0.001, {surface, "1", hostile_name}, "a.csv"},
                            {0.041, 0.002, {surface, "1", "2"}, "b.csv"},
                            {0.047, 0.001, {surface, hostile_name, "1"}, "c.csv"},
                            {0.090, 0.001, {surface, hostile_name, "2"}, hostile_name}};
    replicates.data.exclusions = {{3, hostile_name}};
    replicates.model = statistics::mixed_model(replicates.data);
    return replicates;
}

/// Every kind of mark, both kinds of axis, a map, notes, names of points, and one figure that cannot be drawn.
inline std::vector<study_figures::StudyFigure> sample_figures() {
    using figures::Mark;
    const Array1D q = (Array1D::LinSpaced(50, 4.0, 10.0) * std::log(10.0)).exp(), psd = 1e-3 * q.pow(-3.0);
    figures::Panel spectra{.title = "A",
                           .x = {.quantity = "wavevector *q*", .unit = "1/m", .logarithmic = true},
                           .y = {.quantity = "*C*_1D", .unit = "m3", .logarithmic = true}};
    spectra.series.push_back(
        {.label = "band", .x = q, .y = psd, .lower = 0.5 * psd, .upper = 2.0 * psd, .mark = Mark::band});
    spectra.series.push_back({.label = hostile_name, .x = q, .y = 3.0 * psd, .mark = Mark::line});
    spectra.series.back().y[7] = undefined;
    figures::Panel work{.title = "B",
                        .x = {.quantity = "predicted *W*_app", .unit = "mJ/m2"},
                        .y = {.quantity = "measured *W*_app", .unit = "mJ/m2", .from = 0.0, .to = 60.0},
                        .horizontal_lines = {37.0}};
    const Array1D few = Array1D::LinSpaced(4, 10.0, 40.0);
    work.series.push_back({.label = "pairs",
                           .x = few,
                           .y = few + 3.0,
                           .lower = few,
                           .upper = few + 6.0,
                           .mark = Mark::points,
                           .hollow = true,
                           .left = few - 2.0,
                           .right = few + 2.0,
                           .names = {"first", "second, with a comma", "<b>third</b>", hostile_name}});
    work.series.push_back({.label = "equal", .x = few, .y = few, .mark = Mark::both});
    work.notes.push_back({.text = "a note", .x = 20.0, .y = 50.0});
    figures::Panel categories{.x = {.quantity = "surface", .tick_labels = {"PUNCD", hostile_name}},
                              .y = {.quantity = "*h*_rms", .unit = "nm", .logarithmic = true}};
    categories.series.push_back(
        {.x = Array1D::LinSpaced(2, 0.0, 1.0), .y = Array1D::LinSpaced(2, 5.0, 50.0), .mark = Mark::points});
    figures::Panel map{.x = {.quantity = "*x*", .unit = "um"}, .y = {.quantity = "*y*", .unit = "um"}};
    map.map = figures::HeatMap{
        .values = Array2D::NullaryExpr(6, 4, [](Index i, Index j) { return static_cast<double>(10 * i + j); }),
        .width = 3.0,
        .height = 2.0,
        .values_axis = {.quantity = "*h*", .unit = "nm"}};
    // one legend for two panels, an entry for the series of a colour
    figures::Panel left{.x = {.quantity = "*q*", .unit = "1/m", .logarithmic = true},
                        .y = {.quantity = "*P*/*E*", .logarithmic = true}},
        right = left;
    right.legend = false;
    for (auto* panel : {&left, &right})
        for (int colour : {0, 1})
            panel->series.push_back({.label = "measurement " + std::to_string(colour),
                                     .x = few,
                                     .y = 0.02 * few,
                                     .mark = Mark::line,
                                     .colour = colour,
                                     .in_legend = false});
    left.series.push_back({.label = "stylus", .mark = Mark::line, .colour = 0, .legend_only = true});
    left.series.push_back({.label = "AFM", .mark = Mark::line, .colour = 1, .legend_only = true});
    return {{.identifier = "1",
             .name = "figure_1",
             .title = "Spectra and work",
             .caption = "What <is> drawn.",
             .figure = {.panels = {spectra, work}, .columns = 2, .width_mm = 178.0, .height_mm = 70.0}},
            {.identifier = "spectra:it's",
             .name = "figure_2",
             .title = "Kinds of panel",
             .caption = "Categories and a map.",
             .figure = {.panels = {categories, map, left, right}, .columns = 2, .width_mm = 178.0, .height_mm = 140.0}},
            {.identifier = "S5",
             .name = "figure_S5",
             .title = "Contact radius",
             .caption = "",
             .figure = {},
             .reason = "no experiment has a contact radius"}};
}

}  // namespace setae::tests
