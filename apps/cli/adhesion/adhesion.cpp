// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <utility>

#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "psd/surface_options.hpp"
#include "setae/answers/adhesion_fields.hpp"
#include "setae/core/layout.hpp"
#include "setae/output/contact_answers.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/predicted_quantities.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::cli::adhesion_command {
namespace {

constexpr const char* explanation =
    "The command predicts the work of adhesion of a soft solid on a rough surface from the power spectral density.\n"
    "\n"
    "contact modulus                    1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2\n"
    "true area (Eq. 9)                  r = A_true/A_app = 1 + sqrt(pi)/2 h' exp(1/h'^2) erfc(1/h')\n"
    "stored energy (Eq. 8)              U_el/A_app = (E*/8) int q C1D dq\n"
    "  of one map                       (E*/8 pi) int q^2 C_iso dq, and (E*/4) sum |q| |h_q|^2 over the modes of the map\n"
    "full-contact balance (Eq. 7)       W_app = W_int r - gamma_1 (r - 1) - U_el/A_app\n"
    "Persson-Tosatti balance (Eq. S13)  W_app = W_int (1 + h'^2/2) - U_el/A_app\n"
    "small-slope balance (Eq. 2)        W_app = W_int r - U_el/A_app\n"
    "full or partial contact            W_app = W gain(U_el/AW), W = W_int r - gamma_1 (r - 1)\n"
    "\n"
    "The gain of full or partial contact comes from simulated patches (docs/concepts/conformity.md).\n"
    "This prediction is the result of the command. In full contact it equals the full-contact balance (Eq. 7).\n"
    "A second table contains the full-contact balance (Eq. 7) and Persson's theory with W, both without load.\n"
    "Loop of a sphere: a_max is the contact radius of JKR (Eq. 1) with W_app.\n"
    "W_app is a lower bound of W_ret, and 3/2 pi R W_app a lower bound of the pull-off force (Eq. S1).\n"
    "The loss of the two jumps of a JKR sphere is a lower bound of E_loss.\n"
    "True-area loss (Eq. 10), for comparison: E_loss = W_int r pi a_max^2. It does not tend to the loss of a smooth sphere.\n"
    "bridging: above this wavevector the roughness stores more energy than full contact gains.\n"
    "pressed: above this wavevector it stores more than 0.25 of the gain. Full contact then forms only under pressure.\n"
    "\n"
    "Equation numbers: Dalvi et al., PNAS 116 (2019) 25484 [D19].\n";

struct Arguments {
    Common common;
    SurfaceOptions surface;
    answers::AdhesionRequest solids;
};

ExitCode run(const Arguments& arguments) {
    const auto analysis = arguments.surface.analysis();
    const auto threads = arguments.common.workers();
    (void)arguments.solids.study(analysis);  // throws for wrong options before files are read
    auto surface = study::analyse_surface(arguments.surface.surface(), analysis,
                                          {.previews = false, .parameters = false, .map = true}, threads);
    const auto code = report_failures(surface.surface);
    if (code == ExitCode::nothing_done) return code;
    auto adhesion = answers::adhesion(std::move(surface), analysis, arguments.solids, threads);
    if (arguments.common.json) {
        print_json(output::described(adhesion));
        return code;
    }
    const auto others = show_reading_warnings(adhesion.alerts());
    print(output::adhesion_answer(adhesion.result));
    // the text of the result reports where a work of adhesion is floored
    std::erase_if(adhesion.quantities, [](const auto& q) { return q.quantity.ends_with("_floored"); });
    const auto width = output_size().width;
    print("\n" + tables::as_text_within(output::theory_table(adhesion.answers), width) + "  " +
          wrapped(adhesion.answers.reason, width, 2) + "\n\n");
    if (const auto& loop = adhesion.result.pairs.front().loop)
        print(tables::as_text_within(output::retraction_table(*loop), width) + "\n");
    print(output::quantity_table("", adhesion.quantities, width));
    show(others);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    options.ask(arguments->solids);
    options.example("setae adhesion stylus.csv afm.ibw --E \"0.7 ± 0.02 MPa\" --w \"37 ± 3.7 mJ/m2\" --gamma 25mJ/m2",
                    "work of adhesion of a soft solid on the measured surface");
    options.example("setae adhesion spectrum.csv --E 0.7MPa --w 37mJ/m2 --gamma 25mJ/m2 --radius 1.25mm --preload 1mN",
                    "work of adhesion from the table of a spectrum, with pull-off force and loss of a sphere");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::adhesion_command
