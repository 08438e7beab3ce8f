// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "setae/answers/containers.hpp"

namespace setae::answers {

bool at_fault(const formats::ContainerReport& report) {
    return !report.differences.empty() ||
           std::any_of(report.alerts.begin(), report.alerts.end(), [](const Alert& alert) {
               return alert.code == "UNREADABLE_MEMBER" || alert.code == "COPY_DIFFERS";
           });
}

}  // namespace setae::answers
