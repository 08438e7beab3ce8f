// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/program_tree.hpp"
#include "setae/core/text.hpp"

namespace setae::cli::completion_command {
namespace {

constexpr const char* explanation =
    "The command writes the completion for a shell, with the commands and options of this version.\n"
    "\n"
    "bash  setae completion bash > ~/.local/share/bash-completion/completions/setae\n"
    "zsh   setae completion zsh > ~/.zfunc/_setae        (with ~/.zfunc in $fpath)\n"
    "fish  setae completion fish > ~/.config/fish/completions/setae.fish\n"
    "\n"
    "`setae man` writes the manual page.\n";

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

std::vector<std::string> names(const std::vector<ProgramOption>& options) {
    std::vector<std::string> flags;
    for (const auto& option : options) flags.insert(flags.end(), option.flags.begin(), option.flags.end());
    return flags;
}

/// Lines of a shell's `case`: "    WORD) NAME=TEXT ;;".
std::string case_line(const std::string& word, const char* name, const std::string& text) {
    return fmt::format("    {}) {}={} ;;\n", shell_word(word), name, shell_word(text));
}

/// The words that the argument of a command accepts, if it accepts no other text.
std::string argument_words(const ProgramCommand& command) {
    return command.positionals.empty() ? std::string() : joined(command.positionals.front().choices);
}

/// Completes the words of an option after this option, options after a dash, else commands or words of the argument.
/// Without a match, files are completed.
std::string bash(const std::vector<ProgramCommand>& commands) {
    std::string options, words, values, groups;
    for (const auto& command : commands) {
        options += case_line(command.path, "options", joined(names(command.options)));
        const auto next = command.subcommands.empty() ? argument_words(command) : joined(command.subcommands);
        if (!next.empty()) words += case_line(command.path, "words", next);
        if (!command.subcommands.empty())
            groups +=
                fmt::format("    {}) echo {} ;;\n", shell_word(command.path), shell_word(joined(command.subcommands)));
        for (const auto& option : command.options)
            for (const auto& flag : option.flags)
                if (!option.choices.empty())
                    values += case_line(command.path + " " + flag, "values", joined(option.choices));
    }
    return fmt::format(R"(# bash completion of setae; written by `setae completion bash`
_setae() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} last=${{COMP_WORDS[COMP_CWORD-1]}} path= word= options= words= values=
  if [ "$current" = = ]; then current=; elif [ "$last" = = ]; then last=${{COMP_WORDS[COMP_CWORD-2]}}; fi
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case $word in -*) ;; *) case " $(_setae_commands "$path") " in *" $word "*) path="${{path:+$path }}$word" ;; esac ;; esac
  done
  case "$path $last" in
{}  esac
  case $path in
{}  esac
  case $path in
{}  esac
  if [ -z "$values" ]; then case $current in -*) values=$options ;; *) values=$words ;; esac; fi
  COMPREPLY=($(compgen -W "$values" -- "$current"))
  local IFS=$'\n'
  [ ${{#COMPREPLY[@]}} -gt 0 ] || COMPREPLY=($(compgen -f -- "$current"))
}}
_setae_commands() {{
  case $1 in
{}  esac
}}
complete -o filenames -F _setae setae
)",
                       values, options, words, groups);
}

std::string zsh(const std::vector<ProgramCommand>& commands) {
    // bash's function, which zsh's own layer understands
    return "#compdef setae\n# zsh completion of setae; written by `setae completion zsh`\nautoload -U +X bashcompinit && bashcompinit\n" +
           bash(commands);
}

std::string fish(const std::vector<ProgramCommand>& commands) {
    std::string text = "# fish completion of setae; written by `setae completion fish`\n";
    for (const auto& command : commands) {
        // condition: the line contains the whole path of the command, and no subcommand
        std::string condition;
        for (std::size_t at = 0; at < command.path.size();) {
            const auto end = std::min(command.path.find(' ', at), command.path.size());
            condition += fmt::format("{}__fish_seen_subcommand_from {}", condition.empty() ? "" : "; and ",
                                     command.path.substr(at, end - at));
            at = end + 1;
        }
        const auto next = fmt::format("{}not __fish_seen_subcommand_from {}",
                                      condition.empty() ? "" : condition + "; and ", joined(command.subcommands));
        const auto here = condition.empty() ? "" : " -n " + shell_word(condition);
        for (std::size_t i = 0; i < command.subcommands.size(); ++i)
            text += fmt::format("complete -c setae -n {}{} -a {} -d {}\n", shell_word(next),
                                command.positionals.empty() ? " -f" : "", shell_word(command.subcommands[i]),
                                shell_word(command.subcommand_descriptions[i]));
        if (const auto words = argument_words(command); !words.empty())
            text += fmt::format("complete -c setae{} -f -a {}\n", here, shell_word(words));
        for (const auto& option : command.options) {
            std::string flags;
            for (const auto& flag : option.flags)
                flags += flag.starts_with("--") ? " -l " + flag.substr(2) : " -s " + flag.substr(1);
            const auto value = !option.choices.empty() ? " -x -a " + shell_word(joined(option.choices))
                               : option.takes_value    ? " -r"
                                                       : "";
            text += fmt::format("complete -c setae{}{}{} -d {}\n", here, flags, value, shell_word(option.description));
        }
    }
    return text;
}

struct Arguments {
    Common common;
    std::string shell;
};

ExitCode run(const Arguments& arguments) {
    const auto commands = program_commands();
    print(arguments.shell == "bash" ? bash(commands) : arguments.shell == "zsh" ? zsh(commands) : fish(commands));
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("shell", arguments->shell, "bash, zsh or fish").required().one_of_unlisted({"bash", "zsh", "fish"});
    options.example("setae completion bash > ~/.local/share/bash-completion/completions/setae", "completion for bash");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::completion_command
