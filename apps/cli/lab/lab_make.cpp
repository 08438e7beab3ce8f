// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"
#include "setae/simulation/data_set.hpp"

namespace setae::cli::lab_make_command {
namespace {

constexpr const char* explanation_of_make =
    "The command simulates the measurements and loops of a recipe and writes their files.\n"
    "\n"
    "surfaces    random with a given C_iso; heights Gaussian, or a function g(z) of Gaussian heights with a given skewness\n"
    "stylus, AFM dilated by the tip in two dimensions, sampled at points, with noise\n"
    "TEM         line through the surface, traced in random steps\n"
    "W_app       full-contact balance (Eq. 7): W_int r - gamma_1 (r - 1) - U_el/A_app, r = A_true/A_app\n"
    "W_ret       true-area loss (Eq. 10): E_loss = f W_int r pi a_max^2; or pinning: W_app + 2 k U_el/A_app\n"
    "loops       JKR with W_app, edge pinned at a_max until G = W_ret, JKR with W_ret\n"
    "\n"
    "truth.json contains every true value. study.toml analyses the data: setae study FOLDER/study.toml.\n"
    "Equation numbers: Dalvi et al., PNAS 116 (2019) 25484 [D19].\n";

struct MakeArguments {
    Common common;
    std::string file;
    std::string output = "laboratory";
    std::optional<std::uint64_t> seed;
};

constexpr std::array asked{
    fields::option<&MakeArguments::seed>("seed", "seed of the data set").or_else("the seed of the recipe"),
};

ExitCode run_make(const MakeArguments& arguments) {
    if (arguments.file.empty())
        throw InvalidArgument("no recipe; expected a TOML file, such as examples/laboratory/recipe.toml");
    const auto recipe = simulation::read_recipe(arguments.file, arguments.seed);
    const auto files = simulation::make(recipe, arguments.output, arguments.common.workers());
    if (arguments.common.json)
        print_json(output::described(simulation::MakeOutput{arguments.file, recipe.seed, arguments.output, files}));
    else
        print(fmt::format("{}: {} files, seed {}; analyse them with: setae study {}/study.toml\n", arguments.output,
                          files.size(), recipe.seed, arguments.output));
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<MakeArguments>();
    options.add("recipe", arguments->file, "TOML file of the recipe").of_inputs();
    options.output("-o,--output", arguments->output, "folder of the data set; default: laboratory");
    options.ask(asked, arguments.get());
    options.example("setae lab make recipe.toml -o mine", "simulated measurements and loops, with a study file");
    return action(options, arguments, explanation_of_make, run_make);
}

}  // namespace setae::cli::lab_make_command
