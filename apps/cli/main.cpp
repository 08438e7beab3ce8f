// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <exception>

#include "command_line.hpp"
#include "commands/verbs.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/parallel/memory.hpp"
#include "setae/study/provenance.hpp"

namespace {

/// A first word that is no verb, with the nearest one; CLI11 itself would only say that a verb is missing.
std::string unknown_verb(const CLI::App& program, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return {};
    std::vector<std::string> verbs;
    for (const auto* verb : program.get_subcommands([](const CLI::App*) { return true; }))
        verbs.push_back(verb->get_name());
    if (std::find(verbs.begin(), verbs.end(), argv[1]) != verbs.end()) return {};
    const auto nearest = setae::nearest_match(argv[1], verbs);
    return std::string("unknown verb '") + argv[1] + "'" +
           (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") + " `setae --help` lists them";
}

}  // namespace

int main(int argc, char** argv) {
    using namespace setae::cli;
    setae::parallel::keep_freed_memory();
    remember_command_line(argc, argv);
    CLI::App program{"setae: from measured roughness to soft adhesion", "setae"};
    program.set_version_flag("--version", "setae " + setae::study::version());
    program.require_subcommand(1);
    program.footer(
        "Standard output carries data, standard error messages. Exit code 0: done, 1: some items failed, 2: nothing done.");
    Action action;
    add_info(program, action);
    add_formats(program, action);
    add_convert(program, action);
    add_level(program, action);
    add_container(program, action);
    add_contour(program, action);
    add_check(program, action);
    add_profile(program, action);
    add_tip(program, action);
    add_psd(program, action);
    add_sdrp(program, action);
    add_acf(program, action);
    add_vbw(program, action);
    add_params(program, action);
    add_adhesion(program, action);
    add_jkr(program, action);
    add_synthesize(program, action);
    add_study(program, action);
    add_plot(program, action);
    add_lab(program, action);
    add_cache(program, action);
    add_completion(program, action);
    add_man(program, action);
    if (const auto message = unknown_verb(program, argc, argv); !message.empty()) {
        complain(message);
        return static_cast<int>(ExitCode::nothing_done);
    }
    try {
        program.parse(argc, argv);
        return static_cast<int>(action());
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::nothing_done);
    } catch (const setae::Error& error) {
        complain(error.what());
    } catch (const std::exception& error) {
        complain(std::string("internal error: ") + error.what());
    }
    return static_cast<int>(ExitCode::nothing_done);
}
