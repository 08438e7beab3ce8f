// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fields/row.hpp"

namespace setae::fields {

void put(const void* result, const Description& description, Sink& sink) {
    for (const auto& row : description.rows)
        if (row.put) row.put(result, row, sink);
}

}  // namespace setae::fields
