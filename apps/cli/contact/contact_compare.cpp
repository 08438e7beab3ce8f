// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "psd/surface_options.hpp"
#include "setae/answers/comparison_fields.hpp"
#include "setae/file_figures/comparison_figure.hpp"
#include "setae/output/comparison_answer.hpp"
#include "setae/output/field_json.hpp"
#include "setae/platform/terminal.hpp"

namespace setae::cli::contact_compare_command {
namespace {

constexpr const char* explanation =
    "The command compares Persson's theory with the solved contact of random surfaces of the same spectrum.\n"
    "\n"
    "surfaces  random surfaces with the spectrum within its band, as from `setae synthesize --amplitudes exact`\n"
    "contact   p >= 0, g >= 0, p g = 0, with a duality gap as error bound, as in `setae contact solve`\n"
    "theory    Persson's theory of the same spectrum, as in `setae contact persson`\n"
    "area      corrected pixel by pixel for the perimeter of the contact: Yastrebov et al. (2017)\n"
    "±         standard error of the mean over surfaces. The surfaces differ only in the positions of their waves.\n"
    "\n"
    "A cell contains fewer long waves than the spectrum. JSON gives rms_height_of_surfaces next to rms_height.\n"
    "The method is described in docs/concepts/persson.md.\n";

struct Arguments {
    Common common;
    SurfaceOptions surface;
    answers::ComparisonRequest request;
    std::string output;
    FigureOption figure;
};

std::function<void(Index, Index)> progress_line() {
    if (!platform::is_terminal(platform::Stream::errors)) return {};
    return
        [](Index done, Index all) { fmt::print(stderr, "\r{} of {} contacts{}", done, all, done == all ? "\n" : " "); };
}

ExitCode run(const Arguments& arguments) {
    arguments.request.require_complete();
    require_table_or_figure(arguments.output);
    const auto surface = answers::surface_for_theory(arguments.surface.surface(), arguments.surface.analysis(),
                                                     arguments.common.workers());
    const auto code = report_failures(surface);
    if (code == ExitCode::nothing_done) return code;
    const auto comparison =
        answers::compare_contact(surface, arguments.request, arguments.common.workers(), progress_line());
    const Table& load = comparison.load;
    write_table_or_figure(
        arguments.output, load,
        [&] { return file_figures::comparison_figure(load, arguments.surface.files.front(), arguments.figure.look()); },
        arguments.common.json);
    if (arguments.common.json) {
        print_json(output::described(comparison));
        return code;
    }
    print(output::comparison_answer(load, comparison.band, comparison.surfaces, output_size().width));
    show(comparison.alerts);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    auto& request = arguments->request;
    options.ask<answers::BodyRequest>(request.theory);
    options.ask(request.theory);
    options.ask(request);
    options.output("-o,--output", arguments->output, "table OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
    arguments->figure.add_to(options);
    options.example("setae contact compare spectrum.csv --contact-modulus 1GPa --pressure 10MPa,100MPa",
                    "Persson's theory and solved contacts of surfaces with this spectrum, at two pressures");
    options.example(
        "setae contact compare afm.ibw --shortest-wavelength 50nm --contact-modulus 1MPa --pressure 1kPa:1MPa -o contact.svg --width double",
        "comparison against pressure as a figure, with waves down to 50 nm");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::contact_compare_command
