// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <utility>

#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "psd/surface_options.hpp"
#include "setae/answers/adhesion.hpp"
#include "setae/core/layout.hpp"
#include "setae/output/contact_answers.hpp"
#include "setae/output/predicted_quantities.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::cli::adhesion_command {
namespace {

constexpr const char* explanation =
    "E*       1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2\n"
    "r        = A_true/A_app = 1 + sqrt(pi)/2 h' exp(1/h'^2) erfc(1/h')                        [D19] (9)\n"
    "U_el     U_el/A_app = (E*/8) int q C1D dq                                                [D19] (8)\n"
    "         one map: (E*/8 pi) int q^2 C_iso dq, and (E*/4) sum |q| |h_q|^2 of its own modes   [D19] (8)\n"
    "modified W_app = W_int r - gamma_1 (r - 1) - U_el/A_app                                  [D19] (7)\n"
    "Persson-Tosatti W_app = W_int (1 + h'^2/2) - U_el/A_app                                  [D19] (S13)\n"
    "without area change of the soft side W_app = W_int r - U_el/A_app                        [D19] (2)\n"
    "answer   W_app = W gain(U_el/AW), W = W_int r - gamma_1 (r - 1), of simulated patches; (7) where contact is full\n"
    "         beside it: (7), and Persson's theory with W, without load                        docs/concepts/conformity.md\n"
    "loop     a_max by (1) with W_app; W_ret >= W_app, F >= 3/2 pi R W_app, E_loss >= the jumps of JKR   [D19] (1), (S1)\n"
    "         for comparison E_loss = W_int r pi a_max^2, without a smooth limit                [D19] (10)\n"
    "bridging wavevectors q above which the roughness stores more than it gains                docs/concepts/conformity.md\n"
    "pressed  q above which it stores more than 0.25 of that: closes under pressure alone      docs/concepts/conformity.md\n";

struct Arguments {
    Common common;
    SurfaceOptions surface;
    answers::AdhesionRequest solids;
};

ExitCode run(const Arguments& arguments) {
    const auto analysis = arguments.surface.analysis();
    const auto threads = arguments.common.workers();
    (void)arguments.solids.study(analysis);  // what is wrong with it is said before files are read
    auto surface = study::analyse_surface(arguments.surface.surface(), analysis,
                                          {.previews = false, .parameters = false, .map = true}, threads);
    const auto code = report_failures(surface.surface);
    if (code == ExitCode::nothing_done) return code;
    auto adhesion = answers::adhesion(std::move(surface), analysis, arguments.solids, threads);
    if (arguments.common.json) {
        print_json(answers::to_json(adhesion));
        return code;
    }
    const auto others = show_of_reading(adhesion.alerts());
    print(output::adhesion_answer(adhesion.result));
    // the answer says where a work of adhesion is floored
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
                    "from a table of a spectrum, with what a sphere should do");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::adhesion_command
