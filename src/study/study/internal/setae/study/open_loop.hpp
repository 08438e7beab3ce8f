// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/loops/clock_alignment.hpp"
#include "setae/loops/shared_inputs.hpp"
#include "setae/study/loop_source.hpp"
#include "setae/tables/mapping.hpp"

namespace setae::study {

/// A loop as read, in SI.
struct OpenedLoop {
    Table table;
    tables::ChannelNames channels;               ///< where its columns come from
    std::optional<loops::ClockAlignment> clock;  ///< where the camera's offset was looked for
    std::vector<Alert> alerts;                   ///< a doubtful clock, frames without a sample
};

/// Reads a loop: through a mapping where one is given; else setae's own format, a force curve, or a table with the
/// column names of a loop. Columns chosen by the source take precedence. Radii of a camera are converted to the force's
/// clock. @throws FileError, FormatError, InvalidArgument as reading does; FormatError for columns that make no loop,
/// naming `setae jkr import`; InvalidArgument for a camera where a time runs backwards.
[[nodiscard]] OpenedLoop open_loop(const LoopSource& source);

/// The same through a mapping in memory, in place of the source's. @throws as above.
[[nodiscard]] OpenedLoop open_loop(const LoopSource& source, const tables::Mapping& mapping);

/// @throws FormatError for a force curve with missing constants.
void require_constants(const Table& curve, const std::string& file);

/// Bodies, and the standard errors of their stated values.
struct StatedBodies {
    loops::LensAndCounterBody values;
    std::map<loops::SharedInput, double> standard_errors;

    /// Takes a number, which is one of `values`, and its standard error; a missing value changes nothing.
    template <class Number>
    void take(loops::SharedInput input, Number& number, const std::optional<Estimate>& stated) {
        if (!stated) return;
        number = stated->value;
        standard_errors.erase(input);
        if (stated->uncertain()) standard_errors[input] = stated->standard_error;
    }
};

/// The bodies as far as the loop's metadata state them; radius 0 where they do not.
[[nodiscard]] StatedBodies bodies_stated_in(const Table& loop);

/// Multiplies the channels of an open loop.
void apply(const loops::Calibration& factors, OpenedLoop& loop);

/// W [J/m²] of adhesive contacts below which forces are likely too small for the radius.
inline constexpr double min_work_of_adhesion = 3e-4;

/// Whether a warning names a cause that makes all numbers of a loop wrong: it precedes its consequences.
[[nodiscard]] bool names_cause(const Alert& alert);

/// Opens a loop and analyses it, with the warnings of opening and of the analysis.
/// @throws what open_loop() and loops::analyse() throw; every message names the file, that of a ChannelFaultError also
/// the columns to choose.
[[nodiscard]] loops::LoopAnalysis analyse_loop(const LoopSource& source, const loops::LensAndCounterBody& bodies,
                                               const loops::AnalysisOptions& options = {});

/// Analyses a loop that is already open.
[[nodiscard]] loops::LoopAnalysis analyse_loop(const OpenedLoop& opened, const std::string& file,
                                               const loops::LensAndCounterBody& bodies,
                                               const loops::AnalysisOptions& options = {});

/// The analysis with the standard errors of the bodies included in those of the results.
[[nodiscard]] loops::LoopAnalysis analyse_loop(const OpenedLoop& opened, const std::string& file,
                                               const StatedBodies& bodies, const loops::AnalysisOptions& options);

}  // namespace setae::study
