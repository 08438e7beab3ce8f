// SPDX-License-Identifier: GPL-3.0-or-later
// The only part of the program that uses CLI11.
#include "program/parser.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "program/help.hpp"
#include "program/messages.hpp"
#include "program/program_tree.hpp"
#include "program/terminal.hpp"
#include "setae/bytes/protected_inputs.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/study/provenance.hpp"

namespace setae::cli {

namespace {

/// "stage_stiffness" as "--stage-stiffness".
std::string dashed(std::string_view name) {
    std::string option = "--" + std::string(name);
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

}  // namespace

Option& Option::one_of(const std::vector<std::string>& words) {
    return one_of_unlisted(words).value_named(fmt::format("{}", fmt::join(words, "|")));
}
Option& Option::one_of_unlisted(const std::vector<std::string>& words) {
    return offering(words).read_by([words](const std::string& text) {
        if (std::find(words.begin(), words.end(), text) != words.end()) return;
        const auto nearest = nearest_match(text, words);
        throw InvalidArgument(fmt::format("'{}'; expected {}{}", text, fmt::join(words, ", "),
                                          nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
    });
}
Option& Option::offering(const std::vector<std::string>& words) {
    declared_->choices[option_] = words;
    return *this;
}
Option& Option::read_by(const std::function<void(const std::string&)>& read) {
    option_->check(CLI::Validator(
        [read](std::string& text) {
            try {
                read(text);
            } catch (const InvalidArgument& error) {
                return std::string(error.what());
            }
            return std::string();
        },
        ""));
    return *this;
}
Option& Option::between(int min, int max) {
    return read_by([=](const std::string& text) {
        long value = 0;
        if (!CLI::detail::lexical_cast(text, value) || value < min || value > max)
            throw InvalidArgument(fmt::format("'{}', expected a whole number from {} to {}", text, min, max));
    });
}
Option& Option::between(double min, double max) {
    return read_by([=](const std::string& text) {
        double value = 0.0;
        if (!CLI::detail::lexical_cast(text, value) || !(value >= min && value <= max))
            throw InvalidArgument(fmt::format("'{}', expected a number from {} to {}", text, min, max));
    });
}
Option& Option::positive() { return within(domain::positive); }
Option& Option::required() {
    option_->required();
    return *this;
}
Option& Option::in(OptionGroup group) {
    declared_->groups[option_] = group;
    return *this;
}
Option& Option::excludes(const Option& other) {
    option_->excludes(other.option_);
    return *this;
}
Option& Option::separated_by(char separator) {
    option_->delimiter(separator);
    return *this;
}
Option& Option::one_at_a_time() {
    option_->allow_extra_args(false);
    return *this;
}
Option& Option::within(const Domain& domain) {
    return read_by([domain](const std::string& text) {
        double value = 0.0;
        if (!CLI::detail::lexical_cast(text, value)) throw InvalidArgument(fmt::format("'{}' is not a number", text));
        require_within(domain, value, text);
    });
}
Option& Option::natural() {
    return read_by([](const std::string& text) {
        if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos || !spelled<std::uint64_t>(text))
            throw InvalidArgument(fmt::format("'{}', expected a whole number from 0 to {}", text,
                                              std::numeric_limits<std::uint64_t>::max()));
    });
}
Option& Option::quantity(const Expected& expected, const std::string& usual_unit) {
    return read_by([expected, usual_unit](const std::string& text) {
        double number = 0.0;
        if (!usual_unit.empty() && CLI::detail::lexical_cast(text, number))
            throw InvalidArgument(fmt::format("'{0}' has no unit, for instance \"{0} {1}\"", text, usual_unit));
        (void)parse_uncertain_quantity(text, expected);
    });
}
Option& Option::of_inputs() {
    option_->each([](const std::string& path) { bytes::protect_input(path); });
    return *this;
}
Option& Option::value_named(const std::string& name) {
    option_->option_text(name);
    return *this;
}
Option& Option::default_shown() {
    option_->capture_default_str();
    return *this;
}

bool Options::has(const std::string& name) const { return command_.get_option_no_throw(name) != nullptr; }

Option Options::flag(const std::string& names, bool& value, const std::string& description) {
    return {*command_.add_flag(names, value, description), declared_};
}

void Options::example(const std::string& typed, const std::string& what) {
    declared_.examples[&command_].push_back({typed, what});
}

template <class Value>
Option Options::add(const std::string& names, Value& value, const std::string& description) {
    Option option(*command_.add_option(names, value, description), declared_);
    constexpr bool real = std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>> ||
                          std::is_same_v<Value, std::vector<double>>;
    constexpr bool natural =
        std::is_same_v<Value, std::uint64_t> || std::is_same_v<Value, std::optional<std::uint64_t>>;
    return real ? option.within(domain::finite) : natural ? option.natural() : option;
}

void Options::ask(std::span<const fields::Option> asked, void* request, OptionGroup group) {
    for (const auto& option : asked) {
        const auto names = (option.also.empty() ? "" : fmt::format("--{},", option.also)) + dashed(option.name) +
                           (option.word.empty() ? "" : fmt::format(",{}", option.word));
        auto added = std::visit(
            [&](auto* value) {
                if constexpr (std::is_same_v<decltype(value), bool*>)
                    return flag(names, *value, fields::help_of(option));
                else return add(names, *value, fields::help_of(option));
            },
            option.place(request));
        if (option.separator != '\0') added.separated_by(option.separator);
        if (option.named_each_time) added.one_at_a_time();
        if (option.is_input) added.of_inputs();
        if (option.quantity) added.quantity(*option.quantity, std::string(option.usual_unit));
        if (option.domain) added.within(*option.domain);
        if (option.whole) added.between(option.whole->least, option.whole->greatest);
        if (option.offered) added.offering(option.offered());
        if (option.check) added.read_by(option.check);
        if (!option.choices.empty()) added.one_of({option.choices.begin(), option.choices.end()});
        if (option.shows_default) added.default_shown();
        added.in(option.is_required ? OptionGroup::required : option.is_advanced ? OptionGroup::advanced : group);
    }
}

template Option Options::add(const std::string&, std::string&, const std::string&);
template Option Options::add(const std::string&, int&, const std::string&);
template Option Options::add(const std::string&, long&, const std::string&);
template Option Options::add(const std::string&, std::uint64_t&, const std::string&);
template Option Options::add(const std::string&, double&, const std::string&);
template Option Options::add(const std::string&, std::optional<long>&, const std::string&);
template Option Options::add(const std::string&, std::optional<std::uint64_t>&, const std::string&);
template Option Options::add(const std::string&, std::optional<std::string>&, const std::string&);
template Option Options::add(const std::string&, std::optional<double>&, const std::string&);
template Option Options::add(const std::string&, std::vector<std::string>&, const std::string&);
template Option Options::add(const std::string&, std::vector<long>&, const std::string&);
template Option Options::add(const std::string&, std::vector<double>&, const std::string&);

namespace {

bool any(const CLI::App* /*command*/) { return true; }

CLI::App& group_of(CLI::App& program, const Command& row) {
    if (*row.group == '\0') return program;
    const auto added_before =
        program.get_subcommands([&](const CLI::App* command) { return command->get_name() == row.group; });
    if (!added_before.empty()) return *added_before.front();
    const auto declared = command_groups();
    const auto group = std::find_if(declared.begin(), declared.end(),
                                    [&](const CommandGroup& g) { return std::string_view(g.name) == row.group; });
    auto* added = program.add_subcommand(group->name, group->description);
    added->require_subcommand(1);
    return *added;
}

/// The program of CLI11, and the declarations that CLI11 does not store.
struct Program {
    std::unique_ptr<CLI::App> app;
    Declarations declared;
};

/// The program with all its commands; parsing stores the action of the command in `chosen`.
Program program_with_commands(Action& chosen) {
    Program program{std::make_unique<CLI::App>("from measured roughness to soft adhesion", "setae"), {}};
    program.app->set_version_flag("--version", "setae " + study::version());
    program.app->set_help_flag("-h,--help", "print this help, then stop");
    program.app->require_subcommand(1);
    for (const auto& row : commands()) {
        auto* command = group_of(*program.app, row).add_subcommand(row.name, row.description);
        Options options(*command, program.declared);
        // a command can have subcommands, such as study; the last command of the line is run
        command->callback([&chosen, command, action = row.declare(options)] {
            if (command->get_subcommands().empty()) chosen = action;
        });
    }
    return program;
}

/// Message for an unknown first word, with the nearest command; CLI11 would only report a missing command.
std::string unknown_command(const CLI::App& program, const std::vector<std::string>& words) {
    if (words.empty() || words.front().starts_with('-')) return {};
    std::vector<std::string> commands;
    for (const auto* command : program.get_subcommands(any)) commands.push_back(command->get_name());
    if (std::find(commands.begin(), commands.end(), words.front()) != commands.end()) return {};
    const auto nearest = nearest_match(words.front(), commands);
    return "unknown command '" + words.front() + "'" + (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
}

/// The kind of value of an option, for the help.
std::string value_of(const CLI::Option& option) {
    if (!option.get_option_text().empty()) return option.get_option_text();
    const auto type = option.get_type_name();
    const auto several = option.get_items_expected_max() > 1 ? " ..." : "";
    if (type == "INT" || type == "UINT") return std::string("N") + several;
    if (type == "FLOAT") return std::string("NUMBER") + several;
    return type + several;
}

ProgramOption described(const CLI::Option& option, const Declarations& declared) {
    ProgramOption result;
    for (const auto& name : option.get_snames()) result.flags.push_back("-" + name);
    for (const auto& name : option.get_lnames()) result.flags.push_back("--" + name);
    result.takes_value = option.get_items_expected_max() > 0;
    if (result.takes_value) result.value = value_of(option);
    result.description = option.get_description();
    if (!option.get_default_str().empty()) result.description += "; default: " + option.get_default_str();
    if (const auto choices = declared.choices.find(&option); choices != declared.choices.end())
        result.choices = choices->second;
    if (const auto group = declared.groups.find(&option); group != declared.groups.end()) result.group = group->second;
    return result;
}

/// The topic of a command of the program, or of a group of commands.
std::string topic_of(const std::string& name) {
    for (const auto& row : commands())
        if (row.group == name || (*row.group == '\0' && row.name == name)) return row.topic;
    return {};
}

ProgramCommand described(const CLI::App& app, const std::string& path, const Declarations& declared) {
    ProgramCommand command;
    command.path = path;
    command.description = app.get_description();
    for (const auto* option : app.get_options()) {
        auto described_option = described(*option, declared);
        if (option->get_positional()) {
            command.positionals.push_back(described_option);
            command.positionals.back().flags = {option->get_name(true)};
        }
        if (option->nonpositional()) command.options.push_back(std::move(described_option));
    }
    for (const auto* child : app.get_subcommands(any)) {
        command.subcommands.push_back(child->get_name());
        command.subcommand_descriptions.push_back(child->get_description());
        if (path.empty()) command.topics.push_back(topic_of(child->get_name()));
    }
    if (const auto examples = declared.examples.find(&app); examples != declared.examples.end())
        command.examples = examples->second;
    return command;
}

void add_commands(const CLI::App& app, const std::string& path, const Declarations& declared,
                  std::vector<ProgramCommand>& commands) {
    commands.push_back(described(app, path, declared));
    for (const auto* child : app.get_subcommands(any))
        add_commands(*child, path.empty() ? child->get_name() : path + " " + child->get_name(), declared, commands);
}

/// The last command on the command line so far.
const CLI::App& named_command(const CLI::App& program) {
    const auto* command = &program;
    while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
    return *command;
}

std::string path_of(const CLI::App& command) {
    const auto* parent = command.get_parent();
    return parent && parent->get_parent() ? path_of(*parent) + " " + command.get_name() : command.get_name();
}

/// Options of a command as they are typed, with a value or without; a value with blanks in quotes.
fields::Spelling spelling_of(const CLI::App& command) {
    std::set<std::string, std::less<>> names;
    for (const auto* option : command.get_options())
        for (const auto& name : option->get_lnames()) names.insert("--" + name);
    return [names = std::move(names)](std::string_view name, std::string_view value) {
        const auto option = dashed(name);
        if (!names.contains(option)) return std::string();
        const auto* quote = value.find(' ') == value.npos ? "" : "\"";
        return value.empty() ? option : fmt::format("{0} {1}{2}{1}", option, quote, value);
    };
}

/// Error message for a command line: the command, the option, and the nearest option for an unknown one.
std::string parse_error_message(const CLI::App& program, const CLI::ParseError& error) {
    const auto& command = named_command(program);
    const bool of_command = &command != &program;
    const auto help = of_command ? "see `setae help " + path_of(command) + "`" : "see `setae --help`";
    const auto words = program.remaining(true);
    std::string message = error.what();
    if (command.get_require_subcommand_min() > 0) {
        message = words.empty() ? "expected a subcommand" : unknown_command(command, words);
    } else if (dynamic_cast<const CLI::ExtrasError*>(&error)) {
        std::vector<std::string> flags;
        for (const auto* option : command.get_options())
            for (const auto& name : option->get_lnames()) flags.push_back("--" + name);
        const auto word = words.empty() ? std::string() : words.front();
        const auto nearest = nearest_match(word, flags);
        message = word.starts_with("-") ? fmt::format("unknown option '{}'", word)
                                        : fmt::format("unexpected argument '{}'", word);
        if (word.starts_with("-") && !nearest.empty()) message += "; did you mean '" + nearest + "'?";
    }
    return (of_command ? path_of(command) + ": " : "") + message + (message.ends_with('?') ? " " : "; ") + help;
}

/// `help COMMAND…` as `COMMAND… --help`.
std::vector<std::string> help_as_option(std::vector<std::string> words) {
    if (words.empty() || words.front() != "help") return words;
    words.erase(words.begin());
    words.emplace_back("--help");
    return words;
}

/// The words of a command line for CLI11: in reverse order, without the program. A negative number such as "-1.25 mm"
/// is joined to the option before it, because CLI11 would take it for an option.
std::vector<std::string> reversed_words(const std::vector<std::string>& given) {
    std::vector<std::string> words;
    for (const std::string_view word : given) {
        const bool negative =
            word.size() > 1 && word[0] == '-' && (std::isdigit(static_cast<unsigned char>(word[1])) || word[1] == '.');
        const bool of_option = !words.empty() && words.back().starts_with("--") && words.back().size() > 2 &&
                               words.back().find('=') == std::string::npos;
        if (negative && of_option) words.back() += "=" + std::string(word);
        else words.emplace_back(word);
    }
    std::reverse(words.begin(), words.end());
    return words;
}

}  // namespace

Parsed parsed(int argc, char** argv) {
    Parsed result;
    const auto [program, declared] = program_with_commands(result.action);
    auto words = help_as_option({argv + std::min(argc, 1), argv + argc});
    if (words.empty()) words = {"--help"};
    if (words == std::vector<std::string>{"input", "--help"}) {
        print(input_help(program_commands(), output_size().width));
        return result;
    }
    constexpr int nothing_done = static_cast<int>(ExitCode::nothing_done);
    if (const auto message = unknown_command(*program, words); !message.empty()) {
        print_message(message + (message.ends_with('?') ? " " : "; ") + "see `setae --help`");
        result.exit_code = nothing_done;
        return result;
    }
    try {
        program->parse(reversed_words(words));
        spell_options_by(spelling_of(named_command(*program)));
    } catch (const CLI::CallForHelp&) {
        result.action = nullptr;
        const auto& command = named_command(*program);
        print(help_text(described(command, &command == program.get() ? "" : path_of(command), declared),
                        output_size().width));
    } catch (const CLI::Success& asked) {  // --version
        result.action = nullptr;
        result.exit_code = program->exit(asked);
    } catch (const CLI::ParseError& error) {
        result.action = nullptr;
        result.exit_code = nothing_done;
        print_message(parse_error_message(*program, error));
    }
    return result;
}

std::vector<ProgramCommand> program_commands() {
    Action none;
    std::vector<ProgramCommand> commands;
    const auto program = program_with_commands(none);
    add_commands(*program.app, "", program.declared, commands);
    return commands;
}

}  // namespace setae::cli
