// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::output {

/// A kind of alert as a page shows it. What is to be done stands in each alert itself.
struct AlertKind {
    std::string code;
    std::string about;          ///< what it is about: "files", "spectra", …
    std::string said;           ///< when it is said, with its threshold
    std::string rests_on = {};  ///< why the threshold is where it is; empty for alerts without one
};

/// Every kind of alert that setae knows.
[[nodiscard]] std::vector<AlertKind> alert_kinds();

/// Whether alerts of this code are about how a file was read, so that every number depends on them.
[[nodiscard]] bool concerns_reading(const std::string& code);

}  // namespace setae::output
