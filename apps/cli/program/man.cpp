// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/command_page.hpp"
#include "program/messages.hpp"
#include "program/pages.hpp"
#include "program/program_tree.hpp"

namespace setae::cli::man_command {
namespace {

constexpr const char* explanation =
    "The command writes the manual page with all commands and options of this version: setae man | man -l -\n";

/// Text for roff: backslashes and leading dots escaped, hyphens that can be copied.
std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\n' ? " " : std::string(1, c);
    return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string options_part(const std::vector<ProgramOption>& options) {
    std::string text;
    for (const auto& option : options) {
        std::string flags;
        for (const auto& flag : option.flags)
            flags += fmt::format("{}\\fB{}\\fR", flags.empty() ? "" : ", ", roff(flag));
        if (option.takes_value) flags += fmt::format(" \\fI{}\\fR", roff(option.value));
        text += fmt::format(".TP\n{}\n{}\n", flags, roff(option.description));
    }
    return text;
}

std::string examples_part(const std::vector<Example>& examples) {
    std::string text = examples.empty() ? "" : ".PP\nExamples:\n";
    for (const auto& example : examples)
        text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(example.command), roff(example.what));
    return text;
}

std::string command_part(const ProgramCommand& command) {
    std::string text = fmt::format(".SS setae {}", roff(command.path));
    for (const auto& argument : command.positionals) text += fmt::format(" \\fI{}\\fR", roff(argument.flags.front()));
    text += fmt::format("\n{}.\n", roff(command.description));
    for (const auto& argument : command.positionals)
        text += fmt::format(".TP\n\\fI{}\\fR\n{}\n", roff(argument.flags.front()), roff(argument.description));
    return text + options_part(command.options) + examples_part(command.examples);
}

struct Arguments {
    Common common;
    std::string documentation;
};

ExitCode run(const Arguments& arguments) {
    if (!arguments.documentation.empty()) {
        write_pages(arguments.documentation, command_pages());
        return ExitCode::done;
    }
    std::string text =
        ".TH SETAE 1 \"\" \"setae " SETAE_VERSION
        "\" \"User Commands\"\n.SH NAME\nsetae \\- from measured roughness to soft adhesion\n"
        ".SH SYNOPSIS\n\\fBsetae\\fR \\fIcommand\\fR [\\fIfiles and options\\fR]\n.SH DESCRIPTION\n"
        "setae combines measurements of a rough surface by stylus, AFM and TEM into one power spectral density. From it setae predicts true "
        "area, stored elastic energy and the apparent work of adhesion of a soft solid. It analyses JKR loops and compares both. Arguments have "
        "units: 0.7MPa, 37mJ/m2, \"8 nm\".\n.SH COMMANDS\n";
    for (const auto& command : program_commands())
        if (!command.path.empty()) text += command_part(command);
    text +=
        ".SH ENVIRONMENT\n.TP\nSETAE_CACHE\nFolder of results kept between runs; default $XDG_CACHE_HOME/setae, else ~/.cache/setae.\n"
        ".TP\nSOURCE_DATE_EPOCH\nSeconds since 1970 that replace the time of the run in reports, so that two runs give the same bytes.\n"
        ".SH EXIT STATUS\n0: all done, with or without warnings. 1: some items failed, the rest is done. 2: nothing done, or a usage error.\n"
        ".SH SEE ALSO\nThe tutorial, the guide to studies and the glossary in the folder docs of the sources.\n";
    print(text);
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("--documentation", arguments->documentation, "folder for one page per command and their list")
        .in(OptionGroup::advanced);
    options.example("setae man | man -l -", "manual page on the screen");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::man_command
