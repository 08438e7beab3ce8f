// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "convert/heights_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/blind_tip.hpp"
#include "setae/answers/diagnosis.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/study/pipeline_file.hpp"

namespace setae::cli::tip_command {
namespace {

constexpr const char* explanation =
    "The command estimates the shape of the tip from a scan: the bluntest tip that could have made the map.\n"
    "\n"
    "estimate        t(v) >= min_u [i(x) + t(u) - i(x + u - v)] for every point x; Villarrubia 1997\n"
    "tip_height      height of the estimate at the corners of its extent\n"
    "tip_radius      R of t = r^2/(2R) through the apex, least squares over the pixels within two pixels of the apex\n"
    "                The radius is an upper bound: the tip is not blunter than the estimate.\n"
    "certain_share   share of points that exactly one position of the tip touched; the surface is known there\n"
    "reconstruction  the map eroded by the tip: an upper bound of the surface\n"
    "--threshold     twice the largest deviation of the noise; without it noise sharpens the estimate\n"
    "\n"
    "Level and despike the map first (--step): a spike has the effect of a sharp tip.\n";

struct Arguments {
    Common common;
    answers::FileRequest file;
    answers::ProcessingRequest processing;
    answers::BlindTipRequest request;
    std::string path, output, reconstruction;
};

ExitCode run(const Arguments& arguments) {
    if (arguments.path.empty()) throw InvalidArgument("no file; expected a map");
    for (const auto& path : {arguments.output, arguments.reconstruction})
        if (!path.empty()) require_heights_ending(path);
    const auto processed = processing::apply(arguments.processing.pipeline(),
                                             answers::measurements_of(arguments.path, arguments.file).front(),
                                             study::measurement_loader(arguments.file.read_options()));
    show(topography::metadata(processed.measurement).alerts);
    const auto answer =
        answers::blind_tip(arguments.path, processed.measurement, arguments.request, arguments.common.workers());
    if (!arguments.output.empty()) write_heights(arguments.output, answer.tip);
    if (!arguments.reconstruction.empty()) write_heights(arguments.reconstruction, answer.surface);
    if (arguments.common.json) {
        print_json(output::described(answer));
        return ExitCode::done;
    }
    print(output::quantity_table("", answer.quantities, output_size().width));
    show(answer.alerts);
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("file", arguments->path, "map, or container with a map").of_inputs();
    options.ask(arguments->file, OptionGroup::height_files);
    options.ask(arguments->processing);
    options.ask(arguments->request);
    options.output("-o,--output", arguments->output, "file for the tip, apex up: " + endings_of_heights());
    options.output("--reconstruction", arguments->reconstruction,
                   "file for the surface where the surface is certain, undefined elsewhere");
    options.example("setae tip map.ibw -o tip.x3p", "bluntest tip that could have made the map");
    options.example("setae tip map.ibw --threshold \"0.2 nm\" --reconstruction surface.x3p",
                    "tip with allowance for noise, and the surface where the surface is certain");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::tip_command
