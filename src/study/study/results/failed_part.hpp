// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "setae/core/errors.hpp"
#include "setae/core/quantity.hpp"

namespace setae::study {

inline constexpr const char* part_failed = "PART_FAILED";

/// Adds a warning for a part of a study that cannot be computed, once for each reason.
inline void add_failed_part(std::vector<Alert>& alerts, const std::string& part, const std::string& reason) {
    const bool known = std::any_of(alerts.begin(), alerts.end(), [&](const Alert& alert) {
        return alert.code == part_failed && alert.subject == part && alert.message == reason;
    });
    if (!known)
        alerts.push_back(
            {part_failed, part, reason, "check the values that this part uses; all other results are complete"});
}

/// Computes a part of a study; where that fails, the others are computed all the same. @throws Cancelled.
template <class Computation>
bool isolated(std::vector<Alert>& alerts, const std::string& part, const Computation& computation) {
    try {
        computation();
        return true;
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& error) {
        add_failed_part(alerts, part, reason_of(error));
        return false;
    }
}

}  // namespace setae::study
