// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "contact/contact_problem.hpp"
#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/adhesive_contact.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/units.hpp"
#include "setae/file_figures/sweep_figure.hpp"
#include "setae/half_space/adhesive_quantities.hpp"
#include "setae/half_space/loop_checkpoint.hpp"
#include "setae/output/quantity_table.hpp"

namespace setae::cli::contact_sweep_command {
namespace {

constexpr const char* explanation =
    "a rigid rough surface and an elastic half-space that attract each other, brought together and parted; the cell repeats itself\n"
    "  E(g) = 1/2 <(g + h) K (g + h)> + <V(g)>,  g >= 0;  K: k(q) = E* q/2;  V(0) = -w, V'(0) = w/range\n"
    "without --stage-stiffness the mean gap is moved; with it a stage z = gap + A T/k. A soft stage is a dead load in the limit\n"
    "steps     follow the tangent, so that no gap moves by more than the range, and halve where the cell jumps\n"
    "D_n       1/2 (T_(n-1) + T_n) d(gap) - dE, work of the machine that is stored nowhere; their sum is the area of the loop\n"
    "a cell has a loss of its own, even a flat one: it jumps into contact and out of it as a whole   docs/theory/adhesive-cells.md\n";

struct Arguments : answers::BodyRequest, answers::InteractionRequest {
    Common common;
    ContactSurface surface;
    std::string stage_stiffness, to_gap, to_pressure, restart, output;
    FigureOption figure;
};

half_space::LoopOptions options_of(const Arguments& arguments, const half_space::Grid& grid) {
    half_space::LoopOptions options;
    if (!arguments.stage_stiffness.empty())
        options.stage_stiffness =
            parse_quantity(arguments.stage_stiffness, positive(dimension::stiffness)) / grid.area();
    if (!arguments.to_gap.empty()) options.turn = parse_quantity(arguments.to_gap, non_negative(dimension::length));
    if (!arguments.to_pressure.empty())
        options.most_pressure = parse_quantity(arguments.to_pressure, positive(dimension::pressure));
    return options;
}

/// A line on a terminal, now and then: how far on the way, and how long the rest takes at the speed so far.
class ProgressLine {
public:
    /// first, turn: positions [m]; steps so far were of another run.
    ProgressLine(double first, double turn) : first_(first), turn_(turn) {}

    void show(const half_space::LoopStep& step) {
        if (isatty(STDERR_FILENO) == 0) return;
        const double way = (first_ - step.position) / (first_ - turn_);  // 0 … 1 and back
        const double done = 0.5 * (step.approaching ? way : 2.0 - way);
        if (steps_++ == 0) begun_ = done;
        const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        const double left = done > begun_ ? elapsed * (1.0 - done) / (done - begun_) : 0.0;
        fmt::print(stderr, "\r{}, step {}, {:.0f} % of the way{}    ", step.approaching ? "approach" : "separation",
                   steps_, 100.0 * done,
                   elapsed > 2.0 && done > begun_ ? fmt::format(", about {:.0f} s left", left) : "");
    }
    ~ProgressLine() {
        if (steps_ > 0 && isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\n");
    }

private:
    double first_, turn_, begun_ = 0.0;
    int steps_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

half_space::AdhesiveLoop sweep(const answers::TouchingSurface& surface, const Arguments& arguments,
                               const half_space::Body& body, const half_space::Interaction& interaction) {
    auto options = options_of(arguments, surface.grid);
    half_space::AdhesiveCell cell(surface.heights, surface.grid, body, interaction, {}, arguments.common.workers());
    ProgressLine line(cell.far_gap(), options.turn);
    options.progress = [&](const half_space::LoopStep& step) {
        line.show(step);
        return true;
    };
    std::optional<half_space::LoopCheckpoint> begun;
    if (!arguments.restart.empty()) {
        const auto key = half_space::loop_key(surface.heights, surface.grid, body, interaction, options);
        begun = half_space::read_checkpoint(arguments.restart, key);
        if (begun) options.resume = &*begun;
        options.checkpoint = [&, key](const half_space::LoopCheckpoint& checkpoint) {
            half_space::write_checkpoint(arguments.restart, key, checkpoint);
        };
    }
    return half_space::adhesive_loop(cell, options);
}

ExitCode run(const Arguments& arguments) {
    require_table_or_figure(arguments.output);
    const auto body = arguments.body();
    const auto interaction = arguments.interaction();
    const auto processed = arguments.surface.processed();
    const auto surface = answers::touching_surface(arguments.surface.path, processed.measurement);
    const auto loop = sweep(surface, arguments, body, interaction);
    const auto table = half_space::loop_table(loop);
    write_table_or_figure(
        arguments.output, table,
        [&] { return file_figures::sweep_figure(table, arguments.surface.path, arguments.figure.look()); },
        arguments.common.json);
    if (!arguments.restart.empty()) std::filesystem::remove(arguments.restart);
    auto alerts = answers::alerts_of_grid(arguments.surface.path, interaction, body, surface.grid);
    if (!loop.complete)
        alerts.push_back({"CONTACT_NOT_CONVERGED", arguments.surface.path, "some steps of the sweep did not converge",
                          "resolve the range of the attraction with more points"});
    if (arguments.common.json) {
        auto json = answers::sweep_json(loop, surface.grid, body, interaction);
        answers::add_input(json, arguments.surface.path, processed.records, alerts);
        print_json(json);
        return ExitCode::done;
    }
    const auto width = output_size().width;
    print(wrapped(half_space::loop_sentence(loop, interaction), width) + "\n\n" +
          output::quantity_table("", half_space::loop_quantities(loop), width) +
          fmt::format("{} steps\n", loop.steps.size()));
    show(alerts);
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    add_body_options(options, *arguments);
    add_interaction_options(options, *arguments);
    options
        .add("--stage-stiffness", arguments->stage_stiffness,
             "of a stage that is moved, such as \"10 N/m\"; default: the mean gap is moved")
        .quantity(positive(dimension::stiffness));
    options
        .add("--to-gap", arguments->to_gap, "mean gap, or place of the stage, where it turns; default 0: full contact")
        .quantity(non_negative(dimension::length));
    options.add("--to-pressure", arguments->to_pressure, "turn where the mean pressure reaches this")
        .quantity(positive(dimension::pressure));
    options.add(
        "--restart", arguments->restart,
        "file written every 20 steps; where it exists the sweep goes on from there, to the same bytes; removed at the end");
    options.add("-o,--output", arguments->output, "steps OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
    arguments->figure.add_to(options);
    options.example(
        "setae contact sweep map.npy --size \"1 um x 1 um\" --unit m --contact-modulus \"2 MPa\" --w \"50 mJ/m2\" --range \"20 nm\" -o loop.csv",
        "far, full contact and back; a row for each step");
    options.example(
        "setae contact sweep map.npy --size \"1 um x 1 um\" --unit m --contact-modulus \"2 MPa\" --w \"50 mJ/m2\" --range \"20 nm\" --stage-stiffness \"0.1 N/m\" --to-pressure \"10 kPa\" -o loop.svg",
        "on a soft stage, pressed to 10 kPa, as a figure");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::contact_sweep_command
