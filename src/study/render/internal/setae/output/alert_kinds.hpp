// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::output {

/// A kind of warning as a page shows it, in full sentences.
struct AlertKind {
    std::string code;
    std::string about;          ///< what it is about: "files", "spectra", …
    std::string said;           ///< what it means, with its threshold
    std::string effect;         ///< how large the effect on results is, or where its size is printed
    std::string action;         ///< what to do; each warning has an action of its own, too
    std::string rests_on = {};  ///< why the threshold is where it is; empty for warnings without one
};

/// Every kind of alert that setae knows.
[[nodiscard]] std::vector<AlertKind> alert_kinds();

/// Whether alerts of this code are about how a file was read, so that every number depends on them.
[[nodiscard]] bool concerns_reading(const std::string& code);

}  // namespace setae::output
