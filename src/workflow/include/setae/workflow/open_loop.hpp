// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/experiment/analysis.hpp"
#include "setae/experiment/clock_alignment.hpp"
#include "setae/io/mapping.hpp"
#include "setae/workflow/loop_source.hpp"

namespace setae::workflow {

/// A loop as read, in SI.
struct OpenedLoop {
    Table table;
    std::optional<experiment::ClockAlignment> clock;  ///< where the camera's offset was looked for
    std::vector<Alert> alerts;                        ///< a clock that should not be trusted, frames that found no sample
};

/// Reads a loop: through a mapping where one is given; else setae's own format, a force curve, or a table whose columns are
/// named as a loop's. Radii of a camera are put on the force's clock.
/// @throws FileError, FormatError, InvalidArgument as reading does; FormatError for columns that make no loop, naming
/// `setae jkr import`; InvalidArgument for a time that runs backwards.
[[nodiscard]] OpenedLoop open_loop(const LoopSource& source);

/// The same through a mapping in memory, in place of the source's. @throws as above.
[[nodiscard]] OpenedLoop open_loop(const LoopSource& source, const io::Mapping& mapping);

/// The bodies as far as the loop's metadata say them; radius 0 where they do not.
[[nodiscard]] experiment::LensAndCounterBody bodies_stated_in(const Table& loop);

/// Opens a loop and analyses it; the alerts of opening come with those of the analysis.
/// @throws what open_loop() and experiment::analyse() throw; every message names the file.
[[nodiscard]] experiment::LoopAnalysis analyse_loop(const LoopSource& source, const experiment::LensAndCounterBody& bodies,
                                                    const experiment::AnalysisOptions& options = {});

/// The same of a loop already open.
[[nodiscard]] experiment::LoopAnalysis analyse_loop(const OpenedLoop& opened, const std::string& file, const experiment::LensAndCounterBody& bodies,
                                                    const experiment::AnalysisOptions& options = {});

}  // namespace setae::workflow
