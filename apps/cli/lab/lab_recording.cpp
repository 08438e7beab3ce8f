// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/contact_line/line_table.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/output/field_json.hpp"
#include "setae/simulation/recording.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli::lab_recording_command {
namespace {

constexpr const char* explanation =
    "The command renders the edge of a contact as the recording of a camera.\n"
    "The edge is simulated (`setae contact front --save-line`) or measured (`setae jkr line --save-line`).\n"
    "\n"
    "  I = inside + contrast/2 (1 + erf(d/(sqrt 2 blur))) + noise, in 256 levels; d: distance from the edge\n"
    "\n"
    "The edge that `setae jkr line` finds in the recording can be compared with the known edge: docs/guides/contact-line.md.\n";

struct Arguments : simulation::RecordingOptions {
    Common common;
    std::string edge, pixel, output;
};

constexpr std::array asked_of_scale{
    fields::option<&Arguments::pixel>("pixel", "size of a pixel")
        .of(positive(dimension::length))
        .such_as("1 um")
        .required(),
};
using Recording = simulation::RecordingOptions;
constexpr std::array asked{
    fields::option<&Recording::frame_rate>("fps", "frames per second").within(domain::positive).default_shown(),
    fields::option<&Recording::inside>("inside", "grey level of the contact").default_shown(),
    fields::option<&Recording::contrast>("contrast", "difference of grey level between outside and contact")
        .default_shown(),
    fields::option<&Recording::blur>("blur", "standard deviation of the blur of the edge, in pixels")
        .within(domain::positive)
        .default_shown(),
    fields::option<&Recording::noise>("noise", "standard deviation of the noise of a pixel, in grey levels")
        .default_shown(),
    fields::option<&Recording::seed>("seed", "seed of the noise").default_shown(),
};

ExitCode run(const Arguments& arguments) {
    if (arguments.pixel.empty()) throw InvalidArgument("no pixel size; expected --pixel, such as \"1 um\"");
    if (!arguments.output.ends_with(".tif") && !arguments.output.ends_with(".tiff"))
        throw InvalidArgument("expected -o OUT.tif: a recording is a TIFF stack");
    simulation::RecordingOptions options = arguments;
    options.pixel_size = parse_quantity(arguments.pixel, positive(dimension::length));
    options.threads = arguments.common.workers();
    const auto edge = contact_line::line_of(tables::read_table(arguments.edge));
    const auto shape = simulation::write_recording(arguments.output, edge, options);
    if (arguments.common.json)
        print_json(output::described(
            simulation::RecordingOutput{arguments.output, shape, options.pixel_size, options.frame_rate}));
    else print(fmt::format("{}: {} frames of {} x {} px\n", arguments.output, shape.frames, shape.width, shape.height));
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("edge", arguments->edge, "table of the edge: time, radius_1 … radius_N").of_inputs();
    options.ask(asked_of_scale, arguments.get());
    options.ask(asked, static_cast<simulation::RecordingOptions*>(arguments.get()));
    options.output("-o,--output", arguments->output, "TIFF stack OUT.tif").in(OptionGroup::required);
    options.example("setae lab recording edge.csv --pixel \"0.5 um\" --fps 5 -o recording.tif",
                    "TIFF stack for `setae jkr line recording.tif`");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_recording_command
