// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "hysteresis_fields.hpp"
#include "setae/output/field_json.hpp"

namespace setae::output {

Json to_json(const study::Hysteresis& hysteresis) { return described(HysteresisEntry{&hysteresis}); }

}  // namespace setae::output
