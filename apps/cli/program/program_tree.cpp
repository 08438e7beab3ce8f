// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/program_tree.hpp"

#include <algorithm>
#include <iterator>

namespace setae::cli {

std::vector<ProgramOption> options_in(OptionGroup group, const ProgramCommand& command) {
    std::vector<ProgramOption> found;
    std::copy_if(command.options.begin(), command.options.end(), std::back_inserter(found),
                 [group](const ProgramOption& option) { return option.group == group; });
    return found;
}

std::vector<std::string> file_options(const ProgramCommand& command) {
    std::vector<std::string> flags;
    for (const auto group : {OptionGroup::height_files, OptionGroup::loop_files})
        for (const auto& option : options_in(group, command)) flags.push_back(option.flags.back());
    return flags;
}

std::vector<FileOptions> file_options(const std::vector<ProgramCommand>& commands) {
    std::vector<FileOptions> kinds;
    for (const auto& [group, heading] : {std::pair{OptionGroup::height_files, "Files of heights"},
                                         std::pair{OptionGroup::loop_files, "Files of loops"}}) {
        auto& [text, takers, options] = kinds.emplace_back(FileOptions{heading, {}, {}});
        for (const auto& command : commands) {
            const auto own = options_in(group, command);
            if (!own.empty()) takers.push_back(command.path);
            for (const auto& option : own)
                if (std::none_of(options.begin(), options.end(),
                                 [&](const ProgramOption& other) { return other.flags == option.flags; }))
                    options.push_back(option);
        }
    }
    return kinds;
}

}  // namespace setae::cli
