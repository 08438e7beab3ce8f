// SPDX-License-Identifier: GPL-3.0-or-later

#include <array>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lab/closure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/validation/contour_summary.hpp"

namespace setae::cli::lab_contours_command {
namespace {

constexpr const char* explanation =
    "The command traces curves of known shape in rendered micrographs and reports the errors of the traces.\n"
    "\n"
    "pictures    exact coverage of pixels, blur of 0.8 px, noise, fringe, drift, lattice, texture\n"
    "SNR         grey step between vacuum and sample over the noise of a pixel\n"
    "traced      share of the curve that has a trace within 3 px\n"
    "rms         distance along the normal [px], the larger of trace to curve and curve to trace; mean and worst run\n"
    "offset      mean distance, positive where the trace is in vacuum [px]\n"
    "in 2 sigma  share of points closer to the curve than two standard errors; 0.954 for correct standard errors\n"
    "Rq          of the levelled trace over Rq of the curve, minus 1; mean and worst run\n"
    "floor       density of the errors over the noise density that the trace states\n"
    "C1D         of the trace, corrected for response and noise, over C1D of the curve, minus 1\n"
    "            Only wavevectors count where C1D is ten times above the floor.\n";

struct Arguments {
    Common common;
    validation::ContourTrialOptions options;
    std::string output;
};

using Trials = validation::ContourTrialOptions;
constexpr std::array asked{
    fields::option<&Trials::runs>("runs", "number of pictures of each kind").between(1, 100000).default_shown(),
    fields::option<&Trials::first_seed>("seed", "seed of the first run; further runs use the next numbers")
        .default_shown(),
    fields::option<&Trials::size>("size", "number of pixels along each side of a picture")
        .between(200, 8000)
        .default_shown(),
    fields::option<&Trials::kinds>("kind", "kinds of pictures, by name").or_else("all"),
    fields::option<&Trials::pictures>(
        "pictures", "folder for every picture with curve and trace drawn in, and points of the curve"),
};

output::Json json_of(const validation::OverRuns& number) {
    return {{"count", number.count},
            {"mean", output::number(number.mean)},
            {"standard_error", output::number(number.standard_error)},
            {"worst", output::number(number.worst)},
            {"worst_run", number.worst_run}};
}

output::Json json_of(const validation::ContourRow& row) {
    output::Json json{{"kind", row.kind},
                      {"judged", row.judged},
                      {"runs", row.runs},
                      {"refused", row.refused},
                      {"vacuum_mistaken", row.vacuum_mistaken},
                      {"completeness", json_of(row.completeness)},
                      {"rms_error_px", json_of(row.rms_error)},
                      {"largest_error_px", json_of(row.largest_error)},
                      {"offset_px", json_of(row.offset)},
                      {"within_two_errors", json_of(row.within_two_errors)},
                      {"rms_height_ratio", json_of(row.rms_height_ratio)},
                      {"floor_ratio", json_of(row.floor_ratio)},
                      {"overhangs", row.overhangs},
                      {"overhangs_found", row.overhangs_found},
                      {"overhangs_false", row.overhangs_false},
                      {"overhang_depth_ratio", json_of(row.overhang_depth_ratio)},
                      {"spectrum_ratio", output::Json::array()}};
    for (std::size_t band = 0; band < row.spectrum_ratio.size(); ++band) {
        auto ratio = json_of(row.spectrum_ratio[band]);
        ratio["longest_wave_px"] = validation::spectrum_band_ends[band];
        json["spectrum_ratio"].push_back(ratio);
    }
    return json;
}

ExitCode run(const Arguments& arguments) {
    auto options = arguments.options;
    options.threads = arguments.common.workers();
    options.progress = progress_of(options.runs * static_cast<int>(options.kinds.empty()
                                                                       ? validation::contour_kinds(options.size).size()
                                                                       : options.kinds.size()));
    const auto trials = validation::contour_trials(options);
    const auto rows = validation::contour_summary(trials);
    if (!arguments.output.empty()) bytes::write_whole_file(arguments.output, validation::contour_trials_csv(trials));
    if (arguments.common.json) {
        output::Json json{{"runs", options.runs}, {"first_seed", options.first_seed}, {"size", options.size}};
        for (const auto& row : rows) json["rows"].push_back(json_of(row));
        json["verdicts"] = output::Json::array();
        for (const auto& v : validation::contour_verdicts(rows))
            json["verdicts"].push_back(
                {{"kind", v.kind}, {"criterion", v.criterion}, {"passed", v.passed}, {"found", v.found}});
        print_json(json);
    } else {
        print(validation::contour_table(rows) + fmt::format("{} runs from seed {}, pictures of {}² pixels\n",
                                                            options.runs, options.first_seed, options.size));
    }
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.output("-o,--output", arguments->output, "CSV of every trial");
    options.ask(asked, &arguments->options);
    options.example("setae lab contours --runs 10 -o trials.csv", "errors of traced contours against known curves");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_contours_command
