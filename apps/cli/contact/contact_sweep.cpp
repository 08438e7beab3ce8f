// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "contact/contact_problem.hpp"
#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/sweep_fields.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/units.hpp"
#include "setae/file_figures/sweep_figure.hpp"
#include "setae/half_space/adhesive_quantities.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/platform/terminal.hpp"

namespace setae::cli::contact_sweep_command {
namespace {

constexpr const char* explanation =
    "The command moves a rigid rough surface and an elastic half-space together and apart. The two bodies attract each other.\n"
    "The cell is periodic.\n"
    "\n"
    "energy   E(g) = 1/2 <(g + h) K (g + h)> + <V(g)>, g >= 0; K: k(q) = E* q/2; V(0) = -w, dV/dg(0) = w/range\n"
    "control  Without --stage-stiffness the mean gap is prescribed.\n"
    "         With --stage-stiffness k the position of the stage is prescribed, z = gap + A T/k.\n"
    "         A very soft stage is a dead load.\n"
    "steps    Steps follow the tangent, so that no gap changes by more than the range. Steps are halved where the cell jumps.\n"
    "D_n      1/2 (T_(n-1) + T_n) d(gap) - dE: work of the load that is not stored. Its sum is the area of the loop.\n"
    "\n"
    "A cell has a loss of its own, even if it is flat: the whole cell jumps into contact and out of it.\n"
    "The method is described in docs/concepts/adhesive-cells.md.\n";

struct Arguments : answers::SweepRequest {
    Common common;
    ContactSurface surface;
    ContactMaps states;
    std::string output;
    FigureOption figure;
};

/// Progress on one line of a terminal: branch, step, share done, and time left at the mean speed so far.
class ProgressLine {
public:
    void show(const answers::SweepProgress& progress) {
        if (!platform::is_terminal(platform::Stream::errors)) return;
        const double done = progress.share;
        if (steps_++ == 0) begun_ = done;
        const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        const double left = done > begun_ ? elapsed * (1.0 - done) / (done - begun_) : 0.0;
        fmt::print(stderr, "\r{}, step {}, {:.0f} % done{}    ", progress.approaching ? "approach" : "separation",
                   steps_, 100.0 * done,
                   elapsed > 2.0 && done > begun_ ? fmt::format(", about {:.0f} s left", left) : "");
    }
    ~ProgressLine() {
        if (steps_ > 0 && platform::is_terminal(platform::Stream::errors)) fmt::print(stderr, "\n");
    }

private:
    double begun_ = 0.0;  ///< share that an earlier run had done
    int steps_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

answers::SweepAnswer sweep(const topography::Measurement& measurement, const Arguments& arguments) {
    ProgressLine line;
    return answers::adhesive_sweep(arguments.surface.path, measurement, arguments, arguments.common.workers(),
                                   [&](const answers::SweepProgress& progress) {
                                       line.show(progress);
                                       return true;
                                   });
}

void write_states(const answers::SweepAnswer& answer, const Arguments& arguments) {
    std::vector<ContactMaps::State> states;
    for (const auto& maps : answer.maps) {
        auto words = maps.name;
        std::replace(words.begin(), words.end(), '_', ' ');
        states.push_back({maps.name, {words, maps.pressures, maps.gaps}});
    }
    auto maps = arguments.states;
    maps.figure = arguments.figure;
    maps.write(answer.grid, true, answer.file, states, arguments.common.json);
}

ExitCode run(const Arguments& given) {
    auto arguments = given;
    arguments.maps = !arguments.states.output.empty();
    require_table_or_figure(arguments.output);
    arguments.states.require_ending();
    arguments.require_complete();
    const auto processed = arguments.surface.processed(answers::BeyondMap::itself, arguments.common.workers());
    const auto answer = sweep(processed.measurement, arguments);
    write_table_or_figure(
        arguments.output, answer.steps,
        [&] { return file_figures::sweep_figure(answer.steps, answer.file, arguments.figure.look()); },
        arguments.common.json);
    write_states(answer, arguments);
    arguments.finish();
    if (arguments.common.json) {
        print_json(output::described(answers::ContactOutput{&answer, &processed.records}));
        return ExitCode::done;
    }
    const auto width = output_size().width;
    print(wrapped(half_space::loop_sentence(answer.loop, answer.interaction), width) + "\n\n" +
          surface_text(processed, width) + output::quantity_table("", answer.quantities, width) +
          fmt::format("{} steps\n", answer.loop.steps.size()));
    show(answer.alerts);
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    options.ask<answers::BodyRequest>(*arguments);
    options.ask<answers::InteractionRequest>(*arguments);
    options.ask<answers::SweepRequest>(*arguments);
    options.output(
        "--maps", arguments->states.output,
        "maps of pressure [Pa] and gap [m] at the first pressure, the turning point, the first and the largest tension: "
        "OUT_turn_pressure.npy …, with the ending of OUT.npy or OUT.csv, or all in OUT.nc; figure OUT.svg, .pdf or .png");
    options.output("-o,--output", arguments->output, "steps OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
    arguments->figure.add_to(options);
    options.example(
        "setae contact sweep map.npy --size \"1 um x 1 um\" --unit m --contact-modulus \"2 MPa\" --w \"50 mJ/m2\" --range \"20 nm\" -o loop.csv",
        "approach from a large distance, full contact and retraction; table with one row per step");
    options.example(
        "setae contact sweep map.npy --size \"1 um x 1 um\" --unit m --contact-modulus \"2 MPa\" --w \"50 mJ/m2\" --range \"20 nm\" --stage-stiffness \"0.1 N/m\" --to-pressure \"10 kPa\" -o loop.svg",
        "loop on a soft stage up to a pressure of 10 kPa, as a figure");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::contact_sweep_command
