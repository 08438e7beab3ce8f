// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/answers/loops.hpp"
#include "setae/loops/machine_stiffness.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

/// Stiffness of the testing machine from its loop on a rigid body.
/// @throws as loops::machine_stiffness_from_rigid_contact().
[[nodiscard]] loops::MachineStiffness machine_stiffness(const study::OpenedLoop& rigid);

/// "file", "n", "hysteresis", "nonlinearity", "machine_stiffness", "loading" and "unloading", as `setae jkr stiffness`.
[[nodiscard]] output::Json to_json(const std::string& file, const loops::MachineStiffness& found);

}  // namespace setae::answers
