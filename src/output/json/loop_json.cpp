// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "json_support.hpp"
#include "setae/output/field_json.hpp"

namespace setae::output {

using fields::Described;

Json energies_json(const loops::LoopAnalysis& analysis) {
    const auto add_energies = [](Json& json, const loops::ContactAnalysis& contact) {
        add_fields(json, &contact, Described<loops::ContactAnalysis>::energies);
    };
    Json json;
    add_energies(json, analysis);
    json["further_contacts"] = Json::array();
    for (const auto& contact : analysis.further_contacts) {
        Json row = contact ? Json::object() : Json{{"reason", contact.reason}};
        if (contact) add_energies(row, *contact);
        json["further_contacts"].push_back(row);
    }
    json["cycles"] = Json::array();
    for (const auto& cycle : analysis.cycles) {
        Json row;
        add_fields(row, &cycle, Described<loops::CycleAnalysis>::energies);
        json["cycles"].push_back(row);
    }
    json["alerts"] = to_json(analysis.alerts);
    return json;
}

Json to_json(const loops::LoopAnalysis& analysis) {
    Json json;
    add_fields(json, analysis);
    return json;
}

}  // namespace setae::output
