// SPDX-License-Identifier: GPL-3.0-or-later

#include <array>
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/field_json.hpp"
#include "setae/simulation/projection_bias.hpp"
#include "synthesize/synthesis_options.hpp"

namespace setae::cli::lab_foil_command {
namespace {

constexpr const char* explanation =
    "The command computes the effect of the projection of a foil on the spectrum of a contour.\n"
    "\n"
    "silhouette  s(x) = max over 0 <= y <= t of h(x, y): the contour in a micrograph of a foil of thickness t\n"
    "factor      <C1D of silhouettes>/<C1D of lines> of the same random surfaces with the given C_iso\n"
    "\n"
    "C1D of a contour over the factor of each wavevector is the mean C1D of lines of the surface.\n";

struct FoilArguments {
    Common common;
    SynthesisOptions surface;
    std::string thickness;
    int surfaces = 16, bins_per_decade = 4;
};

constexpr std::array asked{
    fields::option<&FoilArguments::thickness>("foil_thickness", "thickness of the foil along the beam")
        .of(positive(dimension::length))
        .such_as("20 nm")
        .required(),
    fields::option<&FoilArguments::surfaces>("surfaces", "number of simulated surfaces")
        .between(2, 10000)
        .default_shown(),
    fields::option<&FoilArguments::bins_per_decade>("bins_per_decade", "number of bins per decade of wavevector")
        .between(1, 100)
        .default_shown(),
};

std::string with_error(const simulation::BiasFactor& factor) {
    return uncertain_number({factor.value, factor.standard_error});
}

ExitCode run(const FoilArguments& arguments) {
    if (arguments.thickness.empty()) throw InvalidArgument("expected --foil-thickness, such as \"20 nm\"");
    const auto plan = arguments.surface.plan(arguments.common.workers());
    if (plan.line || plan.window)
        throw InvalidArgument("the projection of a foil needs a whole surface; leave out --line and --window-of");
    const auto bias =
        simulation::projection_bias(plan.density, {.thickness = parse_quantity(arguments.thickness, dimension::length),
                                                   .grid = plan.grid,
                                                   .surfaces = arguments.surfaces,
                                                   .bins_per_decade = arguments.bins_per_decade,
                                                   .key = plan.options.key,
                                                   .threads = arguments.common.workers()});
    const auto alerts = simulation::projection_alerts(bias, "silhouette");
    if (arguments.common.json) {
        print_json(output::described(simulation::FoilOutput{bias, arguments.surfaces, plan.options.key.seed, alerts}));
        return ExitCode::done;
    }
    std::string text = fmt::format("rms height  {}\nrms slope   {}\nq [1/m]     C1D\n", with_error(bias.rms_height),
                                   with_error(bias.rms_slope));
    for (Index b = 0; b < bias.wavevector.size(); ++b)
        text +=
            fmt::format("{:<11.3g} {}\n", bias.wavevector[b], with_error({bias.C1D[b], bias.C1D_standard_error[b]}));
    print(text);
    show(alerts);
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<FoilArguments>();
    arguments->surface.add_to(options);
    options.ask(asked, arguments.get());
    options.example(
        "setae lab foil --hurst 0.8 --rolloff \"1 um\" --short-cutoff \"1 nm\" --rms-height \"10 nm\" --size \"2 um\" --foil-thickness \"20 nm\"",
        "effect of the thickness of a foil on the spectrum");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_foil_command
