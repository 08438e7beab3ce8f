// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "files/channel_lines.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/container_fields.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/layout.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/container_draft.hpp"
#include "setae/output/field_json.hpp"

namespace setae::cli::container_check_command {
namespace {

constexpr const char* explanation =
    "The command lists surfaces and measurements of a container, with its problems.\n"
    "\n"
    "generation       A: meta.yml; B: index.json with the keys of meta.yml; C: index.json; skeleton: only processed copies\n"
    "heights          read from the original, where the container has it\n"
    "                 height_scale of the index is used only where the original has no scale.\n"
    "SCALE_TWICE      The index repeats a scale that the original contains.\n"
    "COPY_DIFFERS     The original, scaled once and levelled, differs from its processed copy by more than 1e-3 of the rms.\n"
    "NOT_IN_SCHEMA    contact.engineering may refuse this entry.\n"
    "UNKNOWN_FIELD    The field is kept when the container is written again.\n"
    "difference       between the container and its copy written by setae: index and members\n"
    "exit code        0: every part can be read and is unchanged after writing\n"
    "                 1: a part cannot be read or differs after writing\n"
    "                 2: the file is no container\n";

struct Arguments {
    Common common;
    std::vector<std::string> files;
};

std::string report_text(const std::string& file, const formats::ContainerReport& report, std::size_t width) {
    const auto& container = report.file.container;
    auto text =
        fmt::format("{}: generation {}, surfaces {}, measurements {}{}\n", file,
                    formats::describe(report.file.generation), container.surfaces.size(), report.channels.size(),
                    container.created_at.empty() ? "" : ", made " + container.created_at);
    std::size_t index = 0;
    for (const auto& surface : container.surfaces) {
        text += fmt::format("  {}{}{}\n", surface.name.empty() ? "(no name)" : surface.name,
                            surface.category.empty() ? "" : " (" + surface.category + ")",
                            surface.tags.empty() ? "" : fmt::format(", tags {}", fmt::join(surface.tags, ", ")));
        for (std::size_t left = surface.topographies.size(); left > 0; --left, ++index)
            text += fmt::format("    [{}] {}\n", index, channel_line(report.channels[index]));
    }
    for (const auto& alert : report.alerts)
        text += fmt::format("  {}:\n    ", alert.code) +
                wrapped_from(4, fmt::format("{}: {}; {}", alert.subject, alert.message, alert.action), width) + "\n";
    for (const auto& difference : report.differences)
        text += fmt::format("  after writing and reading: {}\n", difference);
    return text + fmt::format("  differences after writing and reading: {}\n",
                              report.differences.empty() ? "none" : std::to_string(report.differences.size()));
}

ExitCode run(const Arguments& arguments) {
    if (arguments.files.empty()) throw InvalidArgument("no file; expected containers, such as measurements.zip");
    answers::CheckedContainers checked;
    bool fault = false;
    const auto code = for_each_item(arguments.files, [&](const std::string& file) {
        auto report = formats::check_container(bytes::file_source(file));
        fault = fault || answers::at_fault(report);
        if (!arguments.common.json) print(report_text(file, report, output_size().width));
        checked.containers.push_back({file, std::move(report)});
    });
    if (arguments.common.json && code != ExitCode::nothing_done) print_json(output::described(checked));
    return code == ExitCode::done && fault ? ExitCode::some_failed : code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("files", arguments->files, "containers").of_inputs();
    options.example("setae container check surface.zip", "content and problems of a container");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::container_check_command
