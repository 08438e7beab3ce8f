// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/pages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/json_schemas.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/validation/described_outputs.hpp"

namespace setae::cli::schema_command {
namespace {

constexpr const char* explanation =
    "The command prints the JSON Schema (draft 2020-12) of the --json output of a command, or of study.json.\n"
    "$id contains the version. Later versions add names and keep existing names: docs/reference/versions.md.\n";

struct Arguments {
    Common common;
    std::vector<std::string> command;
    std::string documentation, output;
};

void write_all(const answers::JsonSchemas& schemas, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const auto commands = schemas.commands();
    for (const auto& command : commands)
        bytes::write_whole_file((folder / answers::schema_file(command)).string(),
                                output::as_text(schemas.of(command)));
    print(fmt::format("{}: {} schemas\n", folder.string(), commands.size()));
}

ExitCode run(const Arguments& arguments) {
    const answers::JsonSchemas schemas(validation::described_outputs);
    if (!arguments.documentation.empty()) {
        const std::filesystem::path folder = arguments.documentation;
        write_page((folder / "json.md").string(), answers::json_page(schemas));
        write_page((folder / "quantities.md").string(), answers::quantities_page(schemas));
    } else if (!arguments.output.empty()) {
        write_all(schemas, arguments.output);
    } else if (!arguments.command.empty()) {
        print_json(schemas.of(fmt::format("{}", fmt::join(arguments.command, " "))));
    } else if (arguments.common.json) {
        print_json({{"verbs", schemas.commands()}});
    } else {
        print(fmt::format("{}\n", fmt::join(schemas.commands(), "\n")));
    }
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("command", arguments->command,
                "command whose JSON is described, such as psd or contact solve; without a command: list of commands");
    options.output("-o,--output", arguments->output, "folder for all schemas, one file per command");
    options.add("--documentation", arguments->documentation, "folder for the documentation pages of all names and quantities")
        .in(OptionGroup::advanced);
    options.example("setae schema study", "names, types, units and meanings in study.json");
    options.example("setae schema contact solve", "JSON Schema of setae contact solve --json");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::schema_command
