// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/data_folder.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"
#include "setae/study/study_result.hpp"
#include "setae/study_figures/figure_fields.hpp"
#include "setae/study_figures/write_figures.hpp"
#include "study/run_arguments.hpp"

namespace setae::cli::plot_command {
namespace {

constexpr const char* explanation =
    "The command draws one figure of a study. docs/reference/figures.md describes all figures.\n"
    "\n"
    "1, 2, 4, S1, S2, S3, S5, S6, S8\n"
    "              figures of Dalvi et al., PNAS 116 (2019) 25484, with error bars\n"
    "spectra:NAME  every measurement of a surface, by instrument, with the excluded data\n"
    "scales        contribution of wavevectors: shares of U_el, excess area and W_app - W_int below q\n"
    "prediction    W_app against E* per surface: full-contact balance (Eq. 7) with band, measured values, residuals, chi2\n"
    "replicates    work of adhesion of every loop with its error, means by lens and surface\n"
    "agreement     measured over expected periodograms, by instrument and decade\n"
    "\n"
    "Error bars and +- are one standard error. Shaded bands are 95 %.\n";

constexpr std::array endings{"svg", "pdf", "png", "csv"};

struct PlotArguments {
    Common common;
    RunArguments run;
    std::string study;
    std::string figure;
    std::string output;
    std::string width = "double";
    bool list = false;

    [[nodiscard]] study_figures::FigureWidth figure_width() const {
        return width == "single" ? study_figures::FigureWidth::single_column
                                 : study_figures::FigureWidth::double_column;
    }
};

std::string ending_of(const std::string& path) {
    auto ending = std::filesystem::path(path).extension().string();
    if (!ending.empty()) ending.erase(0, 1);
    if (std::find(endings.begin(), endings.end(), ending) == endings.end())
        throw InvalidArgument(
            fmt::format("{}: a figure cannot be written as '{}'; expected .svg, .pdf, .png or .csv", path, ending));
    return ending;
}

ExitCode list(const PlotArguments& arguments, const std::vector<study_figures::StudyFigure>& figures) {
    if (arguments.common.json) {
        print_json(output::described(study_figures::FigureList{&figures}));
        return ExitCode::done;
    }
    std::size_t width = 0;
    for (const auto& figure : figures) width = std::max(width, figure.identifier.size());
    for (const auto& figure : figures)
        print(fmt::format("{:<{}}  {}{}\n", figure.identifier, width, figure.title,
                          figure.drawable() ? "" : "; cannot be drawn: " + figure.reason));
    return ExitCode::done;
}

ExitCode plot(const PlotArguments& arguments, const cache::Store& store, ProgressDisplay& display) {
    const auto result = study::run_study(study::read_study(arguments.study, mapping_folder()),
                                         run_options(arguments.common.workers(), store, display));
    display.finish();
    const study_figures::GalleryOptions options{.width = arguments.figure_width(),
                                                .threads = arguments.common.workers()};
    if (arguments.list) return list(arguments, study_figures::study_figures(result, options));
    const auto figure = study_figures::study_figure(result, arguments.figure, options);
    if (!figure.drawable())
        throw UndefinedDataError(fmt::format("figure {} cannot be drawn: {}", figure.identifier, figure.reason));
    const auto output = arguments.output.empty() ? figure.name + ".svg" : arguments.output;
    const auto ending = ending_of(output);
    bytes::write_whole_file(output, ending == "csv"
                                        ? study_figures::data_of(figure, arguments.study, arguments.figure_width())
                                        : study_figures::bytes_of(figure, ending, &store));
    if (arguments.common.json) print_json(output::described(study_figures::PlottedFigure{&figure, output}));
    else print(fmt::format("{}: {}\n{}\n", output, figure.title, figure.caption));
    return ExitCode::done;
}

ExitCode run(const PlotArguments& arguments) {
    if (arguments.study.empty()) throw InvalidArgument("no study; expected a TOML file, see docs/guides/study.md");
    if (!arguments.list && arguments.figure.empty())
        throw InvalidArgument("no figure; expected --figure ID; `setae plot STUDY.toml --list` lists the figures");
    if (!arguments.output.empty()) (void)ending_of(arguments.output);
    const auto store = arguments.run.store();
    ProgressDisplay display(arguments.run.progress_mode());
    return until_interrupted(store, display, [&] { return plot(arguments, store, display); });
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<PlotArguments>();
    options.add("study", arguments->study, "TOML file of the study").of_inputs();
    options
        .add(
            "--figure", arguments->figure,
            "identifier of the figure: 1, 2, 4, S1, S2, S3, S5, S6, S8, spectra:NAME, scales, prediction, replicates, agreement")
        .in(OptionGroup::required);
    options.output("-o,--output", arguments->output,
                   "file OUT.svg, .pdf, .png or .csv; default: the name of the figure as .svg in the current folder");
    options
        .output("--width", arguments->width,
                "width of the figure, one or two columns of a journal: single (85 mm) or double (178 mm)")
        .one_of({"single", "double"})
        .default_shown();
    options.flag("--list", arguments->list,
                 "list of the figures of the study, with the reason where one cannot be drawn; nothing is written");
    arguments->run.add_to(options);
    options.example("setae plot study.toml --list", "list of the figures of a study");
    options.example("setae plot study.toml --figure 4 --width single -o figure.pdf",
                    "figure 4 as PDF, one column wide");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::plot_command
