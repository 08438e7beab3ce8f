// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>

#include "convert/heights_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/synthesis_fields.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/quantity_table.hpp"
#include "synthesize/synthesis_options.hpp"

namespace setae::cli::synthesize_command {
namespace {

constexpr const char* explanation =
    "The command makes a random surface or line with a given power spectrum.\n"
    "\n"
    "C_iso(q)    C_0 for q < q_r, C_0 (q/q_r)^(-2-2H) up to q_s, 0 above; q = 2 pi/wavelength [J17]\n"
    "C1D(q_x)    (1/pi) int_{q_x}^{q_s} C_iso q dq/sqrt(q^2 - q_x^2): lines on that surface\n"
    "h(x)        sum_q c_q exp(iqx), <|c_q|^2> = C_iso/A\n"
    "            c_q is complex normal. With --amplitudes exact only its phase is random.\n"
    "spectrum    h_rms^2 = sum_q C/A and h'^2 = sum_q q^2 C/A over the modes of the grid\n"
    "made        h_rms of the heights written; slopes from differences of neighbouring heights\n"
    "--skewness, --kurtosis\n"
    "            Heights are a function of Gaussian heights (Johnson 1949). The spectrum is corrected for this function.\n"
    "\n"
    "The seed and the mode numbers determine the random number of a mode.\n"
    "More pixels over the same size therefore give the same surface with more modes.\n"
    "[J17] Jacobs, Junge, Pastewka, Surf. Topogr. 5 (2017) 013001.\n";

struct Arguments {
    Common common;
    SynthesisOptions options;
    std::string output;
};

ExitCode run(const Arguments& arguments) {
    if (arguments.output.empty()) throw InvalidArgument("expected -o OUT with an ending " + endings_of_heights());
    require_heights_ending(arguments.output);
    const auto made = answers::synthesis_of(arguments.options, arguments.common.workers());
    write_heights(arguments.output, made.measurement);
    if (arguments.common.json) {
        const answers::SynthesisEntry entry{&made, arguments.output};
        print_json(output::described(&entry, answers::description_of(made)));
        return ExitCode::done;
    }
    const auto points = topography::shape(made.measurement);
    const auto title = fmt::format("{}: {} x {} points", arguments.output, points[0], points[1]);
    print(output::quantity_table(title, made.quantities, output_size().width));
    show(made.plan.alerts);
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->options.add_to(options);
    options.output("-o,--output", arguments->output, "OUT.x3p, .sdf, .gwy, .nc, .npy, .txt or .csv")
        .in(OptionGroup::required);
    options.example(
        "setae synthesize --hurst 0.8 --rolloff \"2 um\" --short-cutoff \"20 nm\" --rms-height \"20 nm\" --size \"10 um\" -o map.x3p",
        "self-affine map");
    options.example("setae synthesize spectrum.csv --size \"5 um\" --pixels 1024 -o map.gwy",
                    "map with the spectrum of a table");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::synthesize_command
