// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr/loop_arguments.hpp"

#include <algorithm>

#include "program/data_folder.hpp"
#include "program/messages.hpp"
#include "setae/core/errors.hpp"

namespace setae::cli {

void add_loop_options(Options& options, answers::LoopFiles& loops, OptionGroup group) {
    loops.mapping_folder = mapping_folder();
    options
        .add(
            "files", loops.files,
            "loops: tables with units in the header, loop files of setae, workbooks, force curves, or folders of these")
        .of_inputs();
    options.ask(fields::Asked<answers::LoopFiles>::mapping, &loops, group);
    options.ask(loops, group);
    options.ask<answers::CameraPictures>(loops, group);
}

void LoopAnalysisRequest::add_to(Options& options) {
    add_loop_options(options, loops, OptionGroup::loop_files);
    options.ask(bodies);
    options.ask(analysis);
}

ExitCode for_each_loop(const LoopAnalysisRequest& request, parallel::Threads threads,
                       const std::function<void(const AnalysedLoop&)>& show_loop) {
    const auto files = request.loops.expanded();
    struct Result {
        std::optional<AnalysedLoop> loop;
        std::string error;
    };
    std::size_t done = 0;
    // in batches, so that a loop is not kept after it was shown
    constexpr std::size_t at_once = 64;
    for (std::size_t first = 0; first < files.size(); first += at_once) {
        std::vector<Result> results(std::min(at_once, files.size() - first));
        parallel::for_each_index(results.size(), threads, [&](std::size_t i) {
            try {
                results[i].loop =
                    answers::analysed_loop(files[first + i], request.loops, request.bodies, request.analysis);
            } catch (const std::exception& error) {
                results[i].error = reason_of(error, files[first + i]);
            }
        });
        for (const auto& result : results) {
            if (result.loop) show_loop(*result.loop);
            else print_message(result.error);
            done += result.loop ? 1 : 0;
        }
    }
    return done == files.size() ? ExitCode::done : done > 0 ? ExitCode::some_failed : ExitCode::nothing_done;
}

}  // namespace setae::cli
