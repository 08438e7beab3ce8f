// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jkr/recording_options.hpp"
#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/line_comparison.hpp"
#include "setae/answers/line_fields.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/file_figures/contact_line_figure.hpp"
#include "setae/output/field_json.hpp"

namespace setae::cli::jkr_line_command {
namespace {

constexpr const char* explanation =
    "The command follows the edge of a contact through a recording, along rays from the mean centre.\n"
    "A table of --save-line, or of a simulation (columns time, radius_1 ... radius_N), can replace the pictures.\n"
    "\n"
    "place         closed path of the steepest steps along the rays; on it the half of the step, by its integral\n"
    "roughness     <|r_n|^2> = A n^-(1 + 2 zeta) + noise, by the Whittle likelihood of modes 3 to N/4\n"
    "              The standard error comes from leaving out blocks of frames.\n"
    "              zeta = 0.39: elastic line with the long range of cracks, quasi-static; Rosso, Krauth (2002)\n"
    "speed         of each cell (a ring at an angle): width over the time in which the edge crosses it\n"
    "              The mean is distance over time.\n"
    "jumps         connected cells faster than --threshold times the mean speed; arrests: slower than 1/threshold\n"
    "tails         p(x) ~ x^-tau above the value that fits best; distance of Kolmogorov; Clauset et al. (2009)\n"
    "release rate  G = G_J(r, d) (1 + 1/r sum |n| r_n exp(in theta)), G_J = E*(d - r^2/R)^2/(2 pi r); Gao, Rice (1987)\n"
    "              Roughness gives G a relative scatter of 2 sqrt(U_el/AW); docs/concepts/crack-front.md.\n"
    "voids         pixels inside the edge that are as bright as the outside\n"
    "\n"
    "The method is described in docs/guides/contact-line.md.\n";

struct Arguments : answers::LineRequest {
    Common common;
    std::vector<std::string> frames;
    std::string output, save_line, other_edge;
    FigureOption figure;
};

answers::RecordedEdge recorded(const Arguments& arguments) {
    auto edge = answers::recorded_edge(arguments.frames, arguments, arguments.common.workers());
    if (edge.radii) report_frames(*edge.radii);
    return edge;
}

/// True if the values of a tail are consistent with its power law: the distance exceeds 1.36/√n in 5 % of cases.
bool fits(const std::optional<contact_line::PowerLawTail>& tail) {
    return tail && tail->distance < 1.36 / std::sqrt(static_cast<double>(tail->count));
}

std::string motion_text(const char* direction, const std::optional<answers::LineMotion>& motion) {
    if (!motion) return {};
    auto text = fmt::format("{}: mean speed {}, cells of {}: {} jumps, {} arrests", direction,
                            format_value(motion->passage.mean_speed, "m/s", 3),
                            format_value(motion->passage.width, "m", 3), motion->jumps.size(), motion->arrests.size());
    if (!motion->jumps.empty())
        text += fmt::format("; the largest jump {}", format_value(motion->jumps.front().area, "m2", 3));
    if (fits(motion->jump_tail))
        text += fmt::format("; areas of jumps fall as S^-{}", uncertain_number(motion->jump_tail->exponent));
    if (fits(motion->speed_tail))
        text += fmt::format("; speeds as v^-{}", uncertain_number(motion->speed_tail->exponent));
    return text;
}

std::string rate_text(const char* direction, const std::optional<answers::ReleaseRate>& rate) {
    if (!rate) return {};
    return fmt::format("{}: energy release rate {}, scatter along the edge {}, as from roughness with U_el/AW = {:.3g}",
                       direction, format_value(rate->mean, "J/m2", 3), format_value(rate->scatter, "J/m2", 3),
                       rate->energy_share());
}

std::string as_text(const answers::LineAnswer& answer) {
    const auto width = output_size().width;
    const auto& recorded = answer.recorded;
    std::string text;
    const auto add = [&](const std::string& line) {
        if (!line.empty()) text += wrapped(line, width, 2) + '\n';
    };
    if (answer.roughness)
        add(fmt::format("roughness exponent of the edge {}, modes {} to {}; deviation from an ellipse {} rms",
                        uncertain_number(answer.roughness->exponent), answer.roughness->smallest_mode,
                        answer.roughness->largest_mode,
                        format_value(std::sqrt(answer.shape.deviation.square().mean()), "m", 3)));
    add(motion_text("retraction", answer.receding));
    add(motion_text("approach", answer.advancing));
    add(rate_text("retraction", answer.retracting_rate));
    add(rate_text("approach", answer.advancing_rate));
    std::size_t voids = 0;
    for (const auto& holes : recorded.voids) voids += holes.empty() ? 0 : 1;
    if (voids > 0) add(fmt::format("voids inside the contact in {} of {} frames", voids, recorded.frames.size()));
    const double error = recorded.line.place_error;
    add(fmt::format("{} frames, {} places each, {}", recorded.frames.size(), recorded.line.angles(),
                    error > 0.0 ? fmt::format("± {} per place", format_value(error, "m", 2)) : "error not given"));
    return text;
}

std::string comparison_text(const answers::LineAnswer& answer, const answers::LineComparison& comparison,
                            const Arguments& arguments) {
    const auto width = output_size().width;
    const auto name = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
    const auto difference = comparison.difference
                                ? fmt::format("the edges differ by {} rms in {} frames",
                                              format_value(*comparison.difference, "m", 3), comparison.frames)
                                : std::string("the edges have no common times");
    return wrapped(difference, width) + "\n\n" +
           tables::as_text_within(answers::comparison_table(answer, comparison, name(arguments.frames.front()),
                                                            name(arguments.other_edge)),
                                  width);
}

Array1D jump_areas(const std::optional<answers::LineMotion>& motion) {
    return motion ? answers::areas_of(motion->jumps) : Array1D();
}

Array1D speeds(const std::optional<answers::LineMotion>& motion) {
    return motion ? contact_line::relative_speeds(motion->passage) : Array1D();
}

file_figures::StudyFigure figure(const answers::LineAnswer& answer, const Arguments& arguments) {
    return file_figures::contact_line_figure({.line = answer.recorded.line,
                                              .roughness = answer.roughness.value_or(contact_line::LineRoughness{}),
                                              .retracting_speeds = speeds(answer.receding),
                                              .advancing_speeds = speeds(answer.advancing),
                                              .retracting_jumps = jump_areas(answer.receding),
                                              .advancing_jumps = jump_areas(answer.advancing)},
                                             arguments.frames.front(), arguments.figure.look());
}

ExitCode run(const Arguments& arguments) {
    require_table_or_figure(arguments.output);
    const auto answer = answers::contact_line_answer(recorded(arguments), arguments);
    const auto& kept = answer.recorded;
    if (!arguments.save_line.empty()) bytes::write_whole_file(arguments.save_line, answers::line_csv(kept));
    write_table_or_figure(
        arguments.output, answers::as_table(answer), [&] { return figure(answer, arguments); }, arguments.common.json);
    if (!arguments.other_edge.empty()) {
        const auto comparison =
            answers::beside(answer, answers::recorded_edge({arguments.other_edge}, arguments), arguments);
        if (arguments.common.json) print_json(output::described(answers::ComparedLine{&answer, &comparison}));
        else print(comparison_text(answer, comparison, arguments));
    } else if (arguments.common.json) {
        print_json(output::described(answer));
    } else {
        print(as_text(answer));
    }
    for (const auto& frame : kept.left_out) print_message(frame);
    for (const auto& note : answer.notes) print_message(note);
    return kept.left_out.empty() ? ExitCode::done : ExitCode::some_failed;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options
        .add(
            "frames", arguments->frames,
            "a TIFF stack, an AVI, a folder of pictures, or pictures (PNG, JPEG, TIFF, BMP); or a table of --save-line")
        .of_inputs();
    options.ask<answers::CameraPictures>(*arguments);
    options.ask<answers::RadiusRequest>(*arguments);
    options.ask<answers::LineRequest>(*arguments);
    options
        .add("--beside", arguments->other_edge,
             "table of another edge of this contact for comparison, such as a simulated edge")
        .of_inputs();
    options.output("--save-line", arguments->save_line, "table OUT.csv of the edge: r at every angle and time");
    options.output("-o,--output", arguments->output, "table OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
    arguments->figure.add_to(options);
    options.example("setae jkr line recording.avi --pixel \"1.82 um\" --fps 10 -o line.svg",
                    "roughness and motion of the edge of a contact, with a figure");
    options.example("setae jkr line stack.tif --um-per-px 1.82 --fps 10 --save-line edge.csv -o frames.csv",
                    "edge of every frame as a table, and one row per frame");
    options.example("setae jkr line edge.csv --ring-width \"5 um\"",
                    "analysis of a saved edge with cells of another size");
    options.example(
        "setae jkr line recording.avi --pixel \"1.82 um\" --fps 10 --radius \"1 mm\" --contact-modulus \"1 MPa\" --displacement stage.csv",
        "energy release rate along the edge");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_line_command
