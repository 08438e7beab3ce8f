// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"

namespace setae::output {

/// Alerts of one kind, by kind: what misleads most first, then in the order they were found.
struct AlertGroup {
    std::string code;
    std::vector<Alert> alerts;  ///< at least one
};
[[nodiscard]] std::vector<AlertGroup> grouped_alerts(const std::vector<Alert>& alerts);

/// Whether a kind is a general warning: it describes the surface or the method and puts no number in doubt.
[[nodiscard]] bool is_general_warning(const std::string& code);

/// "CODE: subject: message; action".
[[nodiscard]] std::string warning_line(const Alert& alert);

/// One line per alert, the worst kind first: of a kind with three subjects or more the first in full and the names of
/// the others, and one line that counts the general warnings.
[[nodiscard]] std::vector<std::string> warning_lines(const std::vector<Alert>& alerts,
                                                     std::string (*line_of)(const Alert&) = warning_line);

}  // namespace setae::output
