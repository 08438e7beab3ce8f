// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "contact/contact_problem.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/solve_fields.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/units.hpp"
#include "setae/half_space/adhesive_quantities.hpp"
#include "setae/half_space/contact_quantities.hpp"
#include "setae/half_space/hard_wall.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/platform/terminal.hpp"

namespace setae::cli::contact_solve_command {
namespace {

constexpr const char* explanation =
    "The command solves the contact of a rigid rough surface with an elastic half-space, without friction.\n"
    "Heights point towards the body.\n"
    "\n"
    "contact         p >= 0, g >= 0, p g = 0;  g = u - h + c;  u_q = p_q/k(q); Johnson 1985, ch. 13\n"
    "stiffness       k = E* q/2, E* = E/(1 - nu^2)\n"
    "                Two elastic bodies: 1/E* is the sum of (1 - nu^2)/E, and the heights of both bodies are added.\n"
    "--layer         k of a layer on a rigid base, --bonded or --frictionless; Carbone, Mangialardi 2008\n"
    "--free          The pressure is zero beyond the edges of the map. Without --free the map is periodic.\n"
    "--displacement  measured from first touch: of the far field (--free), of the base of a layer, or of the mean plane\n"
    "--hardness      The body flows where the pressure reaches the hardness.\n"
    "--w, --range    attraction V(g) with V(0) = -w and dV/dg(0) = w/range; docs/concepts/adhesive-cells.md\n"
    "                The result is the equilibrium that is reached from a large distance.\n"
    "area_fraction   share of pixels under pressure\n"
    "                Corrected: minus (pi - 1 + ln 2)/24 of a pixel per outer edge of a pixel; Yastrebov et al. 2017\n"
    "duality_gap     upper bound of the energy above the minimum, over twice the stored energy\n"
    "                A solution is converged if its duality gap is at most --tolerance.\n";

struct Arguments : answers::HardWallRequest, answers::InteractionRequest {
    Common common;
    ContactSurface surface;
    ContactMaps maps;
};

std::function<void(const half_space::SolveProgress&)> progress_line() {
    if (!platform::is_terminal(platform::Stream::errors)) return {};
    return [](const half_space::SolveProgress& progress) {
        fmt::print(stderr, "\r{} x {} points, iteration {}, gap {:.1e} ", progress.nx, progress.ny, progress.iterations,
                   progress.duality_gap);
    };
}

/// Without adhesion.
ExitCode press(const processing::PipelineResult& processed, const Arguments& arguments) {
    const auto progress = progress_line();
    const auto solved = answers::hard_wall(arguments.surface.path, processed.measurement, arguments,
                                           arguments.common.workers(), progress);
    const auto& [file, problem, contact, stiffness, quantities, alerts] = solved;
    if (progress) fmt::print(stderr, "\n");
    arguments.maps.write(problem.grid, problem.edges == half_space::Edges::periodic, file,
                         {{"", {"", contact.pressures, contact.gaps}}}, arguments.common.json);
    if (arguments.common.json) {
        print_json(output::described(answers::ContactOutput{&solved, &processed.records}));
        return ExitCode::done;
    }
    const auto width = output_size().width;
    print(wrapped(half_space::contact_sentence(problem, contact, stiffness), width) + "\n\n" +
          surface_text(processed, width) + output::quantity_table("", quantities, width) +
          fmt::format("{} after {} iterations: duality gap {:.1e}, penetration {}\n",
                      half_space::name_of(contact.status), contact.iterations, contact.certificate.duality_gap,
                      format_value(contact.certificate.penetration, "m")));
    show(alerts);
    return ExitCode::done;
}

/// With adhesion, approached from a large distance.
ExitCode attract(const processing::PipelineResult& processed, const Arguments& arguments) {
    const auto solved = answers::adhesive_contact(arguments.surface.path, processed.measurement, arguments, arguments,
                                                  arguments.common.workers());
    const auto& state = solved.state;
    arguments.maps.write(solved.grid, true, solved.file, {{"", {"", solved.cell.pressures(), solved.cell.gaps()}}},
                         arguments.common.json);
    if (arguments.common.json) {
        print_json(output::described(answers::ContactOutput{&solved, &processed.records}));
        return ExitCode::done;
    }
    const auto width = output_size().width;
    print(wrapped(half_space::adhesive_sentence(solved.cell, state), width) + "\n\n" + surface_text(processed, width) +
          output::quantity_table("", solved.quantities, width) +
          fmt::format("{} after {} iterations: residual {:.1e}\n", state.converged ? "converged" : "not_converged",
                      state.iterations, state.residual));
    show(solved.alerts);
    return ExitCode::done;
}

ExitCode run(const Arguments& arguments) {
    arguments.maps.require_ending();
    arguments.require_complete();
    const auto beyond = arguments.free ? answers::BeyondMap::nothing : answers::BeyondMap::itself;
    const auto processed = arguments.surface.processed(beyond, arguments.common.workers());
    return arguments.given() ? attract(processed, arguments) : press(processed, arguments);
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    options.ask<answers::BodyRequest>(*arguments);
    options.ask<answers::InteractionRequest>(*arguments);
    options.ask<answers::HardWallRequest>(*arguments);
    options.output("-o,--output", arguments->maps.output,
                   "maps OUT_pressure [Pa] and OUT_gap [m] with the ending of OUT.npy or OUT.csv, or both in OUT.nc; "
                   "figure OUT.svg, .pdf or .png");
    arguments->maps.figure.add_to(options);
    options.example(
        "setae contact solve map.npy --size \"1 um x 1 um\" --unit m --contact-modulus \"1 GPa\" --pressure \"10 MPa\"",
        "area, gap and stiffness under a mean pressure");
    options.example(
        "setae contact solve map.ibw --step level_plane --contact-modulus \"2 MPa\" --layer \"20 um\" --bonded --nu 0.5 --pressure \"10 kPa\" --json",
        "levelled map on a thin layer of rubber, as JSON");
    options.example(
        "setae contact solve tip.npy --size \"100 nm x 100 nm\" --unit nm --free --contact-modulus \"50 GPa\" --displacement \"1 nm\" -o contact.npy",
        "one asperity, with maps of pressure and gap");
    options.example(
        "setae contact solve map.npy --size \"1 um x 1 um\" --unit m --contact-modulus \"2 MPa\" --w \"50 mJ/m2\" --range \"20 nm\" --pressure \"1 kPa\"",
        "adhesive contact, approached from a large distance");
    options.example(
        "setae contact solve map.npy --size \"1 um x 1 um\" --unit m --contact-modulus \"2 MPa\" --w \"50 mJ/m2\" --range \"20 nm\" --displacement \"-5 nm\" --stage-stiffness \"0.1 N/m\"",
        "adhesive contact on a soft stage, 5 nm before first touch");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::contact_solve_command
