// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "setae/study/run_options.hpp"

namespace setae::cli {

/// How a long verb shows how far it is, on standard error.
enum class ProgressMode {
    automatic,  ///< a bar on a terminal, JSON lines elsewhere
    bar,        ///< one line that changes: steps, time left, current item
    json,       ///< one JSON object a line: event ("begin", "done"), done, total, stage, item, cached, elapsed_s,
                ///< remaining_s
    none,
};

/// Shows the steps of a run; not more than ten times a second, the first of each stage and the last one always.
class ProgressDisplay {
public:
    explicit ProgressDisplay(ProgressMode mode);
    ~ProgressDisplay() { finish(); }
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;

    /// A step that begins or is done. Calls from several threads come one after the other.
    void show(const study::Progress& progress);
    /// Clears the line, so that messages stand by themselves.
    void finish();
    [[nodiscard]] const study::Progress& last() const { return last_; }

private:
    using Clock = std::chrono::steady_clock;
    void print(double elapsed) const;
    /// Seconds the steps to come will take, at the pace of those that were computed; nothing where there is no saying.
    [[nodiscard]] std::optional<double> remaining(double elapsed) const;

    ProgressMode mode_;
    Clock::time_point start_, shown_{};
    study::Progress last_;
    std::string shown_stage_;
    bool line_ = false;
    std::mutex mutex_;
};

}  // namespace setae::cli
