// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/table.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

/// {"wavevector": [1e5, …], …, "units": {"wavevector": "1/m", …}}.
[[nodiscard]] output::Json columns_json(const Table& table);

}  // namespace setae::answers
