// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/pressures.hpp"

#include <cmath>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::answers {

Array1D pressures_of(const std::string& text) {
    constexpr double per_decade = 10.0;
    if (const auto colon = text.find(':'); colon != std::string::npos) {
        const double from = parse_quantity(text.substr(0, colon), positive(dimension::pressure)),
                     to = parse_quantity(text.substr(colon + 1), positive(dimension::pressure));
        if (!(from < to)) throw InvalidArgument(fmt::format("'{}'; expected a range that rises, as 1MPa:100MPa", text));
        const auto steps = static_cast<Index>(std::ceil(per_decade * std::log10(to / from) - 1e-9));
        return Array1D::NullaryExpr(steps + 1, [&](Index i) {
            return i == steps ? to : from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(steps));
        });
    }
    std::vector<double> values;
    std::istringstream list(text);
    for (std::string one; std::getline(list, one, ',');) values.push_back(parse_quantity(one, dimension::pressure));
    return Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
}

}  // namespace setae::answers
