// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::output {

/// A kind of warning as a page shows it, in full sentences.
struct AlertKind {
    std::string code;
    std::string about;          ///< topic: "files", "spectra", …
    std::string said;           ///< meaning, with the threshold
    std::string effect;         ///< how large the effect on results is, or where its size is printed
    std::string action;         ///< recommended action; each warning has an action of its own, too
    std::string rests_on = {};  ///< why the threshold is where it is; empty for warnings without one
};

/// Every kind of warning of setae.
[[nodiscard]] std::vector<AlertKind> alert_kinds();

/// Whether warnings of this code concern the reading of a file, so that every number depends on them.
[[nodiscard]] bool concerns_reading(const std::string& code);

}  // namespace setae::output
