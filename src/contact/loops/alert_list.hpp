// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// Collects warnings about one subject.
class AlertList {
public:
    explicit AlertList(std::string subject) : subject_(std::move(subject)) {}

    void add(std::string code, std::string message, std::string action) {
        alerts_.push_back({std::move(code), subject_, std::move(message), std::move(action)});
    }
    [[nodiscard]] std::vector<Alert> take() { return std::move(alerts_); }

private:
    std::string subject_;
    std::vector<Alert> alerts_;
};

/// Faults of the record itself, or apparent errors of units: times, saturation, frames, sizes, several contacts.
void check_record(AlertList& list, const LoopAnalysis& analysis, const Loop& loop, const LensAndCounterBody& bodies,
                  const AlertLimits& limits);

/// The zero of force: where it is known from, its drift, sudden steps of the force.
void check_drift(AlertList& list, const LoopAnalysis& analysis, const Loop& loop, const AlertLimits& limits);

}  // namespace setae::loops
