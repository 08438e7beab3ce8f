// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/loop.hpp"

#include <string>

#include "setae/core/errors.hpp"

namespace setae::loops {

Loop loop_from_table(const Table& table) {
    const auto series = [&](const char* name) {
        const Column* column = table.find(name);
        return column ? column->values : Array1D();
    };
    Loop loop{.time = series("time"),
              .force = table.at("force"),
              .displacement = series("displacement"),
              .contact_radius = series("contact_radius")};
    if (loop.displacement.size() == 0 && loop.contact_radius.size() == 0)
        throw InvalidArgument(
            "a loop needs a column 'displacement' or 'contact_radius' in addition to 'force'; map one of "
            "them");
    return loop;
}

}  // namespace setae::loops
