// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/replicates.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/figures/figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/replicate_report.hpp"
#include "setae/study_figures/forest_plot.hpp"

namespace setae::cli::jkr_summary_command {
namespace {

namespace fs = std::filesystem;

constexpr const char* explanation =
    "The command computes means of fits over lenses, spots and repeats with a mixed model.\n"
    "\n"
    "model                y = mean of the surface + b(lens) + b(spot) + b(repeat) + error of the fit, each normal\n"
    "                     The variance of the fit is known from its standard error.\n"
    "variances            maximum of the restricted likelihood, >= 0, pooled over surfaces\n"
    "                     Levels whose variances cannot be distinguished are reported.\n"
    "mean                 1'V^-1 y/1'V^-1 1, variance 1/1'V^-1 1, Student's t with the degrees of freedom of Satterthwaite\n"
    "prediction interval  one more measurement with another lens, spot and repeat\n"
    "I2, Q                Q = sum (y - mean)^2/SE^2, I2 = 1 - (n - 1)/Q\n"
    "                     I2 is the share of the scatter that the errors of the fits do not explain.\n"
    "excluded             Rows are excluded only with a reason. Excluded rows remain in every table and figure.\n"
    "                     The mean including them is printed next to the mean.\n"
    "\n"
    "Sources: docs/guides/replicates.md; Patterson, Thompson, Biometrika 58 (1971) 545.\n";

struct Arguments {
    Common common;
    answers::ReplicateRequest request;
    std::string output, figure;
};

void write_figure(const std::string& path, const study::ReplicateTables& tables, const figures::Figure& figure) {
    auto ending = fs::path(path).extension().string();
    if (!ending.empty()) ending.erase(0, 1);
    if (ending == "csv") return bytes::write_whole_file(path, tables::as_csv(output::replicate_table(tables.data)));
    constexpr std::array endings{"svg", "pdf", "png"};
    if (std::find(endings.begin(), endings.end(), ending) == endings.end())
        throw InvalidArgument(
            fmt::format("{}: a figure cannot be written as '{}'; expected .svg, .pdf, .png or .csv", path, ending));
    bytes::write_whole_file(path, figures::drawn(figure, ending));
}

void write_folder(const fs::path& folder, const study::ReplicateTables& tables, const statistics::MixedModel& model,
                  const output::Json& json, const figures::Figure& figure) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) throw FileError(fmt::format("{}: cannot create the folder ({})", folder.string(), failure.message()));
    bytes::write_whole_file((folder / "summary.json").string(), output::as_text(json));
    bytes::write_whole_file((folder / "replicates.csv").string(), tables::as_csv(output::replicate_table(tables.data)));
    bytes::write_whole_file((folder / "means.csv").string(),
                            tables::as_csv(output::replicate_mean_table(tables.data, model)));
    for (const char* ending : {"svg", "pdf", "png"})
        write_figure((folder / (std::string("forest.") + ending)).string(), tables, figure);
}

ExitCode run(const Arguments& arguments) {
    const auto summary = answers::replicate_summary(arguments.request);
    const auto& [tables, model] = summary;
    const auto figure = study_figures::forest_plot(tables.data, model, {.quantity = tables.data.quantity});
    const auto json = output::described(summary);
    for (const auto& bad : tables.bad_rows)
        print_message(fmt::format("{}: {}; this row is excluded", bad.place, bad.reason));
    if (!arguments.figure.empty()) write_figure(arguments.figure, tables, figure);
    if (!arguments.output.empty()) write_folder(arguments.output, tables, model, json, figure);
    if (arguments.common.json) print_json(json);
    else print(output::summary(tables.data, model, output_size().width));
    return tables.bad_rows.empty() ? ExitCode::done : ExitCode::some_failed;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    auto& request = arguments->request;
    options
        .add("files", request.files,
             "tables with one row per fit: those of `setae jkr fit --tidy`, or any CSV with units in the header")
        .of_inputs();
    options.ask(request);
    options.output("--figure", arguments->figure, "file of the forest plot: .svg, .pdf, .png or .csv");
    options.output("-o,--output", arguments->output, "folder for summary.json, tables and the forest plot");
    options.example("setae jkr summary fits.csv --group-by surface,lens --figure forest.svg",
                    "means of the fits in a table of `setae jkr fit --tidy`");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_summary_command
