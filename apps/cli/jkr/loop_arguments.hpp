// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "program/exit_code.hpp"
#include "program/options.hpp"
#include "setae/answers/loops.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::cli {

/// Files of loops, how their columns are named, the camera's record, constants of force curves.
void ask_for_loops(Options& options, answers::LoopFiles& loops);

/// All that verbs that analyse loops are told.
struct LoopAnalysisRequest {
    answers::LoopFiles loops;
    answers::LoopBodies bodies;
    answers::LoopSettings analysis;

    void add_to(Options& options);
};

using answers::AnalysedLoop;

/// Analyses every loop on the threads given and shows them one after the other, in the order of the files. A
/// setae::Error of one loop is printed and the others go on.
[[nodiscard]] ExitCode for_each_loop(const LoopAnalysisRequest& request, parallel::Threads threads,
                                     const std::function<void(const AnalysedLoop&)>& show_loop);

}  // namespace setae::cli
