// SPDX-License-Identifier: GPL-3.0-or-later

#include <array>
#include <memory>

#include <fmt/format.h>

#include "lab/closure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/output/field_json.hpp"
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
        print_json(output::described(validation::ContoursOutput{options.runs, options.first_seed, options.size, rows,
                                                                validation::contour_verdicts(rows)}));
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
