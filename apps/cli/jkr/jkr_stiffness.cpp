// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/data_folder.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/machine_stiffness.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/output/field_json.hpp"

namespace setae::cli::jkr_stiffness_command {
namespace {

constexpr const char* explanation =
    "The command determines the stiffness of the testing machine from a loop on a rigid body.\n"
    "\n"
    "k          slope of force against the position of the stage, robust against outliers\n"
    "           Both branches are used, above a fifth of the largest force.\n"
    "error      scatter of the residuals with their correlation, and half the difference of the branches\n"
    "curvature  change of the slope from the lower to the upper half of the forces\n"
    "           A change of more than a tenth indicates a soft contact. Such a loop is refused.\n"
    "use        setae jkr fit LOOP.csv --machine-stiffness \"K ± ERROR\", or --rigid-contact with the file itself\n";

struct Arguments {
    Common common;
    answers::LoopFiles loops;
};

std::string as_text(const std::string& file, const loops::MachineStiffness& found) {
    const auto shown = [](const Estimate& e) { return format_uncertain(e, "N/m"); };
    std::string text =
        fmt::format("{}: k = {}, {} samples; loading {}", file, shown(found.stiffness), found.n, shown(found.loading));
    if (std::isfinite(found.unloading.value))
        text += fmt::format(", unloading {}, difference of the branches {:.2g} % of the deflection",
                            shown(found.unloading), 100.0 * found.hysteresis);
    return text + fmt::format("; slope changes by {:.2g} % over the forces\n", 100.0 * found.nonlinearity);
}

ExitCode run(const Arguments& arguments) {
    if (arguments.loops.files.empty())
        throw InvalidArgument("no file; expected a loop on a rigid body: setae jkr stiffness RIGID.csv");
    output::Json all = output::Json::array();
    const ExitCode code = for_each_item(arguments.loops.files, [&](const std::string& file) {
        const auto found = answers::machine_stiffness(arguments.loops.open(file));
        if (arguments.common.json) all.push_back(output::described(answers::StiffnessOfFile{file, found}));
        else print(as_text(file, found));
    });
    if (arguments.common.json) print_json(arguments.loops.files.size() == 1 && all.size() == 1 ? all.front() : all);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->loops.mapping_folder = mapping_folder();
    options.add("files", arguments->loops.files, "loops on a rigid body: force against the position of the stage")
        .of_inputs();
    options.ask(fields::Asked<answers::LoopFiles>::mapping, &arguments->loops);
    options.example("setae jkr stiffness rigid.csv", "stiffness of the testing machine from a loop on a rigid body");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_stiffness_command
