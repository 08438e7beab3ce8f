// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "setae/output/field_json.hpp"
#include "setae/output/hysteresis_output.hpp"

namespace setae::output {

Json to_json(const study::Hysteresis& h) {
    constexpr std::size_t one_line = 100000;
    Json json{{"answer", hysteresis_answer(h, one_line)}};
    add_fields(json, h);
    return json;
}

}  // namespace setae::output
