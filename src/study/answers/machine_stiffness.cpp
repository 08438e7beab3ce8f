// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/machine_stiffness.hpp"

namespace setae::answers {

loops::MachineStiffness machine_stiffness(const study::OpenedLoop& rigid) {
    return loops::machine_stiffness_from_rigid_contact(loops::loop_from_table(rigid.table));
}

}  // namespace setae::answers
