// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "setae/study/run_options.hpp"

namespace setae::cli {

/// Form of the progress on standard error.
enum class ProgressMode {
    automatic,  ///< a bar on a terminal, JSON lines elsewhere
    bar,        ///< one line that changes: steps, time left, current item
    json,       ///< one JSON object per line: event ("begin", "done"), done, total, stage, item, cached, elapsed_s,
                ///< remaining_s
    none,
};

/// Shows the steps of a run, at most ten times per second. The first step of a stage and the last step are always
/// shown.
class ProgressDisplay {
public:
    explicit ProgressDisplay(ProgressMode mode);
    ~ProgressDisplay() { finish(); }
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;

    /// Shows a step that begins or is done. Calls from several threads are serialised.
    void show(const study::Progress& progress);
    /// Clears the line before messages are printed.
    void finish();
    [[nodiscard]] const study::Progress& last() const { return last_; }

private:
    using Clock = std::chrono::steady_clock;
    void print(double elapsed) const;
    /// Estimated seconds for the remaining steps, from the time of the computed steps; nothing without an estimate.
    [[nodiscard]] std::optional<double> remaining(double elapsed) const;

    ProgressMode mode_;
    Clock::time_point start_, shown_{};
    study::Progress last_;
    std::string shown_stage_;
    bool line_ = false;
    std::mutex mutex_;
};

}  // namespace setae::cli
