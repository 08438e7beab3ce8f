// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "lab_area.hpp"
#include "lab_causes.hpp"
#include "lab_closure.hpp"
#include "lab_contours.hpp"
#include "lab_foil.hpp"
#include "lab_loops.hpp"
#include "setae/core/errors.hpp"
#include "setae/simulation/data_set.hpp"
#include "verbs.hpp"

namespace setae::cli {
namespace {

constexpr const char* explanation_of_make =
    "surfaces    random with a given C_iso; heights Gaussian, or g(z) of such with a given skewness\n"
    "stylus, AFM dilated by the tip in two dimensions, read pointwise, noise\n"
    "TEM         line through the surface, traced in random steps\n"
    "W_app       W_int r - gamma_1 (r - 1) - U_el/A_app, r = A_true/A_app                       [D19] (7)\n"
    "W_ret       such that E_loss = f W_int r pi a_max^2, or W_app + 2 k U_el/A_app              [D19] (10); pinning\n"
    "loops       JKR with W_app, edge pinned at a_max until G = W_ret, JKR with W_ret\n"
    "truth.json holds every planted value, study.toml analyses the data: setae study FOLDER/study.toml\n";

struct MakeArguments {
    Common common;
    std::string file;
    std::string output = "laboratory";
    std::optional<std::uint64_t> seed;
};

ExitCode run_make(const MakeArguments& arguments) {
    if (arguments.file.empty())
        throw InvalidArgument("no recipe; expected a TOML file, such as examples/laboratory/recipe.toml");
    const auto recipe = simulation::read_recipe(arguments.file, arguments.seed);
    const auto files = simulation::make(recipe, arguments.output, arguments.common.workers());
    if (arguments.common.json)
        print_json({{"recipe", arguments.file}, {"seed", recipe.seed}, {"folder", arguments.output}, {"files", files}});
    else
        print(fmt::format("{}: {} files, seed {}; analyse them with: setae study {}/study.toml\n", arguments.output,
                          files.size(), recipe.seed, arguments.output));
    return ExitCode::done;
}

void add_make(CLI::App& group, Action& action) {
    auto arguments = std::make_shared<MakeArguments>();
    auto* verb = group.add_subcommand("make", "write what instruments would record on surfaces and loops of a recipe");
    verb->add_option("recipe", arguments->file, "TOML file of the recipe");
    verb->add_option("-o,--output", arguments->output, "folder of the data set; default: laboratory");
    verb->add_option("--seed", arguments->seed, "in place of the recipe's");
    on_named(*verb, action, arguments, explanation_of_make, run_make);
}

}  // namespace

void add_lab(CLI::App& program, Action& action) {
    auto* group = program.add_subcommand("lab", "measurements simulated on surfaces of which everything is known");
    group->require_subcommand(1);
    add_make(*group, action);
    add_closure(*group, action);
    add_causes(*group, action);
    add_area(*group, action);
    add_lab_loops(*group, action);
    add_lab_contours(*group, action);
    add_lab_foil(*group, action);
}

}  // namespace setae::cli
