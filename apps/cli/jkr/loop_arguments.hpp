// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "program/exit_code.hpp"
#include "program/options.hpp"
#include "setae/answers/loops.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::cli {

/// Options for files of loops: names of columns, record of the camera, constants of force curves.
void add_loop_options(Options& options, answers::LoopFiles& loops, OptionGroup group = OptionGroup::common);

/// Options of commands that analyse loops.
struct LoopAnalysisRequest {
    answers::LoopFiles loops;
    answers::LoopBodies bodies;
    answers::LoopSettings analysis;

    void add_to(Options& options);
};

using answers::AnalysedLoop;

/// Analyses every loop with `threads` and passes the loops to show_loop one by one, in the order of the files. A
/// setae::Error of one loop is printed; the other loops are analysed.
[[nodiscard]] ExitCode for_each_loop(const LoopAnalysisRequest& request, parallel::Threads threads,
                                     const std::function<void(const AnalysedLoop&)>& show_loop);

}  // namespace setae::cli
