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
    "bash   setae completion bash > ~/.local/share/bash-completion/completions/setae\n"
    "zsh    setae completion zsh > ~/.zfunc/_setae        (with ~/.zfunc in $fpath)\n"
    "fish   setae completion fish > ~/.config/fish/completions/setae.fish\n"
    "made from the program's own verbs and options, so they are those of this version; `setae man` writes the manual page\n";

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

/// Words a verb may be followed by: its verbs and options; files besides.
std::string bash(const std::vector<ProgramVerb>& verbs) {
    std::string cases;
    for (const auto& verb : verbs)
        cases += fmt::format("    {}) words={} ;;\n", shell_word(verb.path),
                             shell_word(joined(verb.verbs) + " " + joined(names(verb.options))));
    return fmt::format(R"(# bash completion of setae; written by `setae completion bash`
_setae() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} path= word words=
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case $word in -*) ;; *) case " $(_setae_verbs "$path") " in *" $word "*) path="${{path:+$path }}$word" ;; esac ;; esac
  done
  case $path in
{}  esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
  [ ${{#COMPREPLY[@]}} -gt 0 ] || COMPREPLY=($(compgen -f -- "$current"))
}}
_setae_verbs() {{
  case $1 in
{}  esac
}}
complete -o filenames -F _setae setae
)",
                       cases, [&verbs] {
                           std::string text;
                           for (const auto& verb : verbs)
                               if (!verb.verbs.empty())
                                   text += fmt::format("    {}) echo {} ;;\n", shell_word(verb.path),
                                                       shell_word(joined(verb.verbs)));
                           return text;
                       }());
}

std::string zsh(const std::vector<ProgramVerb>& verbs) {
    // bash's function, which zsh's own layer understands
    return "#compdef setae\n# zsh completion of setae; written by `setae completion zsh`\nautoload -U +X bashcompinit && bashcompinit\n" +
           bash(verbs);
}

std::string fish(const std::vector<ProgramVerb>& verbs) {
    std::string text = "# fish completion of setae; written by `setae completion fish`\n";
    for (const auto& verb : verbs) {
        // words that are there already: all of the verb's path, and none of what may follow
        std::string condition;
        for (std::size_t at = 0; at < verb.path.size();) {
            const auto end = std::min(verb.path.find(' ', at), verb.path.size());
            condition += fmt::format("{}__fish_seen_subcommand_from {}", condition.empty() ? "" : "; and ",
                                     verb.path.substr(at, end - at));
            at = end + 1;
        }
        const auto next = fmt::format("{}not __fish_seen_subcommand_from {}",
                                      condition.empty() ? "" : condition + "; and ", joined(verb.verbs));
        for (std::size_t i = 0; i < verb.verbs.size(); ++i)
            text += fmt::format("complete -c setae -n {}{} -a {} -d {}\n", shell_word(next),
                                verb.positionals.empty() ? " -f" : "", shell_word(verb.verbs[i]),
                                shell_word(verb.verb_descriptions[i]));
        for (const auto& option : verb.options) {
            std::string flags;
            for (const auto& flag : option.flags)
                flags += flag.starts_with("--") ? " -l " + flag.substr(2) : " -s " + flag.substr(1);
            text +=
                fmt::format("complete -c setae{}{}{} -d {}\n", condition.empty() ? "" : " -n " + shell_word(condition),
                            flags, option.takes_value ? " -r" : "", shell_word(option.description));
        }
    }
    return text;
}

struct Arguments {
    Common common;
    std::string shell;
};

ExitCode run(const Arguments& arguments) {
    const auto verbs = program_verbs();
    print(arguments.shell == "bash" ? bash(verbs) : arguments.shell == "zsh" ? zsh(verbs) : fish(verbs));
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("shell", arguments->shell, "bash, zsh or fish").required().one_of_unlisted({"bash", "zsh", "fish"});
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::completion_command
