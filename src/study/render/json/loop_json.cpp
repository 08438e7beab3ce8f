// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "setae/loops/analysis.hpp"
#include "setae/output/field_json.hpp"

namespace setae::output {

using fields::Described;

Json energies_json(const loops::LoopAnalysis& analysis) {
    const auto energies = [](const loops::ContactAnalysis& contact) {
        return described(&contact, Described<loops::ContactAnalysis>::energies);
    };
    auto json = energies(analysis);
    json["further_contacts"] = Json::array();
    for (const auto& contact : analysis.further_contacts)
        json["further_contacts"].push_back(contact ? energies(*contact) : Json{{"reason", contact.reason}});
    json["cycles"] = Json::array();
    for (const auto& cycle : analysis.cycles)
        json["cycles"].push_back(described(&cycle, Described<loops::CycleAnalysis>::energies));
    json["alerts"] = to_json(analysis.alerts);
    return json;
}

}  // namespace setae::output
