// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/machine_stiffness.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace setae::answers {

loops::MachineStiffness machine_stiffness(const study::OpenedLoop& rigid) {
    return loops::machine_stiffness_from_rigid_contact(loops::loop_from_table(rigid.table));
}

output::Json to_json(const std::string& file, const loops::MachineStiffness& found) {
    output::Json json{{"file", file},
                      {"n", found.n},
                      {"hysteresis", output::number(found.hysteresis)},
                      {"nonlinearity", output::number(found.nonlinearity)}};
    const auto add = [&](const char* name, const Estimate& value) {
        json[name] = output::to_json(output::quantity(name, "k", value, "N/m"));
    };
    add("machine_stiffness", found.stiffness);
    add("loading", found.loading);
    if (std::isfinite(found.unloading.value)) add("unloading", found.unloading);
    else json["unloading"] = nullptr;
    return json;
}

}  // namespace setae::answers
