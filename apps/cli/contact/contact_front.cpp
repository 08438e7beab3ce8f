// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "contact/contact_problem.hpp"
#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/contact_line.hpp"
#include "setae/answers/front_fields.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/units.hpp"
#include "setae/file_figures/front_figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/platform/terminal.hpp"

namespace setae::cli::contact_front_command {
namespace {

constexpr const char* explanation =
    "The command simulates the edge of an adhesive contact: a soft sphere is pressed on a rough surface and pulled off.\n"
    "The edge opens where the energy release rate G exceeds the local work w. It closes where G is smaller than w.\n"
    "\n"
    "stress intensity       <K_R^2> = 2 E* U_el/A, from the roughness inside the edge, in full contact\n"
    "local work             w = W - sqrt(2W/E*) K_R\n"
    "W_appr, W_ret          JKR fits of a(F) on each branch, as in an experiment\n"
    "pinning                2k U_el/A = W_ret - W_appr, for any mean of w\n"
    "--w                    energy per unit area that full contact gains\n"
    "--shortest-wavelength  Shorter waves are left out. Waves shorter than the process zone, E* w/(pi tension^2), do not pin.\n"
    "--to-force, --to-displacement\n"
    "                       The loop turns where a smooth sphere has this force or displacement.\n"
    "                       The displacement is then prescribed step by step.\n"
    "\n"
    "The method is described in docs/concepts/crack-front.md.\n";

struct Arguments : answers::FrontRequest {
    Common common;
    ContactSurface surface;
    int realisations = 1;
    std::string output;
    FigureOption figure;
    std::string save_line;
};

/// Progress in per cent on one line of a terminal.
class ProgressLine {
public:
    bool show(double share) {
        const int percent = static_cast<int>(100.0 * share);
        if (percent == shown_ || !platform::is_terminal(platform::Stream::errors)) return true;
        shown_ = percent;
        fmt::print(stderr, "\rfront: {} % done    ", percent);
        return true;
    }
    ~ProgressLine() {
        if (shown_ >= 0) fmt::print(stderr, "\n");
    }

private:
    int shown_ = -1;
};

ExitCode run(const Arguments& arguments) {
    require_table_or_figure(arguments.output);
    arguments.require_complete();
    if (arguments.save_line.empty() != arguments.duration.empty())
        throw InvalidArgument("expected --save-line and --duration together: the table of the edge contains times");
    const auto threads = arguments.common.workers();
    auto surfaces = arguments.surface.realisations(arguments.realisations, threads);
    std::vector<topography::Measurement> maps;
    for (auto& surface : surfaces) maps.push_back(std::move(surface.measurement));
    ProgressLine line;
    const bool one = maps.size() == 1;  // several maps run in parallel, without progress
    const auto answer =
        answers::contact_front(arguments.surface.path, maps, arguments, threads,
                               one ? [&line](double share) { return line.show(share); } : answers::FrontProgress());
    write_table_or_figure(
        arguments.output, answer.steps,
        [&] { return file_figures::front_figure(answer.steps, answer.contact, answer.file, arguments.figure.look()); },
        arguments.common.json);
    if (!arguments.save_line.empty()) bytes::write_whole_file(arguments.save_line, answers::edge_csv(answer.edge));
    if (arguments.common.json) {
        print_json(output::described(answers::ContactOutput{&answer, &surfaces.front().records}));
        return ExitCode::done;
    }
    const auto width = output_size().width;
    print(wrapped(answers::front_sentence(answer), width, 2) + "\n\n" + surface_text(surfaces.front(), width) +
          output::quantity_table("", answer.quantities, width));
    show(answer.alerts);
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    options.ask<answers::FrontRequest>(*arguments);
    options
        .add("--realisations", arguments->realisations,
             "number of simulated surfaces, with seeds from --seed on; results are means with standard errors")
        .positive();
    options.output("--save-line", arguments->save_line,
                   "file OUT.csv for the edge during contact, r at every angle and time; `setae jkr line` reads it");
    options.output("-o,--output", arguments->output, "steps OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
    arguments->figure.add_to(options);
    options.example(
        "setae contact front map.npy --size \"60 um x 60 um\" --unit m --radius \"100 um\" --contact-modulus \"1 MPa\" --w \"50 mJ/m2\" --to-displacement \"0.3 um\" --shortest-wavelength \"1 um\" -o loop.csv",
        "measured map under a sphere; table with one row per step");
    options.example(
        "setae contact front study.toml --surface A --pixels 512 --cell \"40 um\" --radius \"100 um\" --contact-modulus \"1 MPa\" --w \"50 mJ/m2\" --to-force \"1 uN\" --realisations 4",
        "four surfaces made from the spectrum of surface A of a study");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::contact_front_command
