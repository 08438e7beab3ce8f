// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "convert/heights_output.hpp"
#include "convert/pipeline_option.hpp"
#include "files/file_options.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/diagnosis.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/study/pipeline_file.hpp"
#include "setae/topography/blind_tip.hpp"
#include "setae/topography/certainty.hpp"

namespace setae::cli::tip_command {
namespace {

constexpr const char* explanation =
    "the bluntest tip that could have made the map: t(v) >= min_u [i(x) + t(u) - i(x + u - v)] for every point x       Villarrubia 1997\n"
    "tip_height       of the estimate at the corners of its extent\n"
    "tip_radius       R of t = r^2/(2R) through the apex, least squares over the pixels within two of it; the tip is no blunter\n"
    "certain_share    of the points that the tip touched alone, where the map without the tip is the surface\n"
    "reconstruction   the map eroded by the tip: an upper bound of the surface\n"
    "--threshold      twice the noise's largest deviation, else noise sharpens the tip\n"
    "level and despike first (--step): a spike is a sharp tip\n";

struct Arguments {
    Common common;
    FileOptions file;
    PipelineOption processing;
    std::string path, threshold, output, reconstruction;
    Index points = 21;
    int rounds = 100;
};

topography::HeightMap map_of(const Arguments& arguments) {
    auto processed = processing::apply(arguments.processing.pipeline(),
                                       answers::measurements_of(arguments.path, arguments.file).front(),
                                       study::measurement_loader(arguments.file.read_options()));
    auto* map = std::get_if<topography::HeightMap>(&processed.measurement);
    if (!map) throw InvalidArgument(fmt::format("{}: a line does not show a tip; expected a map", arguments.path));
    return std::move(*map);
}

ExitCode run(const Arguments& arguments) {
    if (arguments.path.empty()) throw InvalidArgument("no file; expected a map");
    for (const auto& path : {arguments.output, arguments.reconstruction})
        if (!path.empty()) require_heights_ending(path);
    const auto map = map_of(arguments);
    topography::BlindTipOptions options{.points_x = arguments.points,
                                        .points_y = arguments.points,
                                        .rounds = arguments.rounds,
                                        .threads = arguments.common.workers()};
    if (!arguments.threshold.empty()) options.noise_threshold = parse_quantity(arguments.threshold, dimension::length);
    const auto blind = topography::blind_tip(map, options);
    const auto certainty = topography::certainty_map(map, blind.tip, {.threads = options.threads});
    const auto& t = blind.tip.heights;
    if (!arguments.output.empty())
        write_heights(arguments.output, topography::HeightMap{-t,
                                                              {static_cast<double>(t.rows()) * blind.tip.pixel_size[0],
                                                               static_cast<double>(t.cols()) * blind.tip.pixel_size[1]},
                                                              false,
                                                              map.metadata});
    if (!arguments.reconstruction.empty()) {
        auto certain = certainty.reconstruction;
        certain.heights = (certainty.certain > 0).select(certain.heights, undefined);
        write_heights(arguments.reconstruction, certain);
    }
    const std::vector<Quantity> quantities{output::quantity("tip_radius", "R", topography::apex_radius(blind.tip), "m"),
                                           output::quantity("tip_height", "t", t.maxCoeff(), "m"),
                                           output::quantity("certain_share", "", certainty.share, "1")};
    std::vector<Alert> alerts;
    if (!blind.converged)
        alerts.push_back({"TIP_NOT_CONVERGED", topography::label(map.metadata),
                          fmt::format("the estimate still sharpened in round {}: the tip may be sharper", blind.rounds),
                          "allow more with --rounds"});
    if (arguments.common.json) {
        output::Json json{{"file", arguments.path}, {"rounds", blind.rounds}, {"converged", blind.converged}};
        for (const auto& q : quantities) json["quantities"].push_back(output::to_json(q));
        json["tip"] = {{"pixel_size", blind.tip.pixel_size}, {"unit", "m"}};
        for (Index i = 0; i < t.rows(); ++i)
            json["tip"]["heights"].push_back(output::numbers(Array1D(t.row(i).transpose())));
        json["alerts"] = output::to_json(alerts);
        print_json(json);
        return ExitCode::done;
    }
    print(output::quantity_table("", quantities, output_size().width));
    show(alerts);
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("file", arguments->path, "a map, or a file or container that holds one").of_inputs();
    arguments->file.add_to(options);
    arguments->processing.add_to(options);
    options.add("--points", arguments->points, "extent of the estimate in pixels, odd").default_shown();
    options
        .add("--threshold", arguments->threshold,
             "height by which the map must demand a sharper tip, such as \"0.2 nm\"; default 0")
        .quantity(non_negative(dimension::length));
    options.add("--rounds", arguments->rounds, "at most so many sweeps over the map").default_shown();
    options.add("-o,--output", arguments->output, "write the tip, apex up: " + endings_of_heights());
    options.add("--reconstruction", arguments->reconstruction,
                "write the surface where it is certain, undefined elsewhere");
    options.example("setae tip map.ibw -o tip.x3p", "the bluntest tip that could have made the map");
    options.example("setae tip map.ibw --threshold \"0.2 nm\" --reconstruction surface.x3p",
                    "with noise allowed for, and the surface where it is certain");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::tip_command
