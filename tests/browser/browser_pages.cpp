// SPDX-License-Identifier: GPL-3.0-or-later
// browser_pages FOLDER: writes the pages the browser looks at: the published study, one with hostile names and every
// kind of figure, and one with sixty measured spectra.
#include <cmath>
#include <filesystem>
#include <iostream>

#include "pages.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/report/report.hpp"

namespace {

using namespace setae;

/// Sixty spectra of 600 points that scatter as measured ones do, each with a label; the numbers are those of a fixed
/// sequence.
study_figures::StudyFigure many_spectra() {
    figures::Panel panel{.x = {.quantity = "wavevector *q*", .unit = "1/m", .logarithmic = true},
                         .y = {.quantity = "*C*_1D", .unit = "m3", .logarithmic = true}};
    std::uint64_t state = 1;
    for (int i = 0; i < 60; ++i) {
        figures::Series series{.label = "measurement " + std::to_string(i + 1),
                               .mark = figures::Mark::line,
                               .colour = i % 3,
                               .dash = 0,
                               .line_width = 0.8};
        series.x = (Array1D::LinSpaced(600, 4.0 + 0.05 * i, 7.0 + 0.05 * i) * std::log(10.0)).exp();
        series.y = 1e-3 * series.x.pow(-3.0);
        for (double& y : series.y) {
            state = state * 6364136223846793005ull + 1442695040888963407ull;
            y *= -std::log((static_cast<double>(state >> 11) + 0.5) * 0x1p-53);
        }
        panel.series.push_back(std::move(series));
    }
    return {.identifier = "spectra:many",
            .name = "spectra_many",
            .title = "Every measurement",
            .caption = "Sixty measured spectra.",
            .figure = {.panels = {std::move(panel)}, .width_mm = 178.0, .height_mm = 110.0}};
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: browser_pages FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder(arguments[1]);
    std::filesystem::create_directories(folder);
    const auto write = [&](const char* name, const study::StudyResult& result,
                           const std::vector<study_figures::StudyFigure>& figures) {
        bytes::write_whole_file((folder / name).string(),
                                report::as_html(result, figures, {"setae study study.toml", "2026-11-21T18:40:20Z"}));
    };
    const auto published = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    write("published.html", published, study_figures::study_figures(published));
    auto hostile = published;
    hostile.study.title = hostile.study.description = tests::hostile_name;
    auto& measurement = hostile.surfaces[0].measurements.emplace_back();
    measurement.file = measurement.name = measurement.error = tests::hostile_name;
    hostile.surfaces[0].alerts.push_back(
        {tests::hostile_name, tests::hostile_name, tests::hostile_name, tests::hostile_name});
    hostile.inputs = {{tests::hostile_name, std::string(64, 'a'), 3}};
    hostile.replicates.push_back(tests::sample_replicates(hostile.surfaces[0].name, tests::hostile_name));
    write("hostile.html", hostile, tests::sample_figures());
    write("many.html", published, {many_spectra()});
    write("empty.html", {}, {});
}
