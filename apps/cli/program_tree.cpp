// SPDX-License-Identifier: GPL-3.0-or-later
#include "program_tree.hpp"

namespace setae::cli {
namespace {

ProgramOption described(const CLI::Option& option) {
    ProgramOption result;
    for (const auto& name : option.get_snames()) result.flags.push_back("-" + name);
    for (const auto& name : option.get_lnames()) result.flags.push_back("--" + name);
    result.takes_value = option.get_items_expected_max() > 0;
    if (result.takes_value)
        result.value = option.get_option_text().empty() ? option.get_type_name() : option.get_option_text();
    result.description = option.get_description();
    return result;
}

void add_verbs(const CLI::App& app, const std::string& path, std::vector<ProgramVerb>& verbs) {
    ProgramVerb verb;
    verb.path = path;
    verb.description = app.get_description();
    for (const auto* option : app.get_options()) {
        if (!option->get_positional()) {
            verb.options.push_back(described(*option));
            continue;
        }
        verb.positionals.push_back(option->get_name(true));
        verb.positional_descriptions.push_back(option->get_description());
    }
    const auto children = app.get_subcommands([](const CLI::App*) { return true; });
    for (const auto* child : children) {
        verb.verbs.push_back(child->get_name());
        verb.verb_descriptions.push_back(child->get_description());
    }
    verbs.push_back(std::move(verb));
    for (const auto* child : children)
        add_verbs(*child, path.empty() ? child->get_name() : path + " " + child->get_name(), verbs);
}

}  // namespace

std::vector<ProgramVerb> verbs_of(const CLI::App& program) {
    std::vector<ProgramVerb> verbs;
    add_verbs(program, "", verbs);
    return verbs;
}

}  // namespace setae::cli
