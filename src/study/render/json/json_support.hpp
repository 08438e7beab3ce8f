// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "setae/loops/analysis.hpp"
#include "setae/output/json.hpp"
#include "setae/study/study_result.hpp"

namespace setae::output {

/// Origin of the parameters of a spectrum, by the conversion.
inline constexpr const char* exact_source = "moments of C1D or C_iso, exact for isotropic surfaces; THEORY 4.1";
inline constexpr const char* eq11_source = "moments of C1D by [D19], Eq. 11";

/// Adds a quantity under its own name.
inline void add(Json& json, const Quantity& q) { json[q.quantity] = to_json(q); }

/// Adds a part, or null with the reason.
template <class T, class Convert>
void add_outcome(Json& json, const std::string& key, const loops::Outcome<T>& outcome, Convert convert) {
    json[key] = outcome ? convert(*outcome) : Json(nullptr);
    if (!outcome) json[key + "_reason"] = outcome.reason;
}

/// Rows of numbers.
[[nodiscard]] Json matrix(const Eigen::MatrixXd& values);

}  // namespace setae::output
