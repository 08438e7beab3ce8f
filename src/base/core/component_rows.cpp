// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/component_rows.hpp"

#include <map>
#include <string_view>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae {
namespace {

/// Column range of the directions of every input.
class Columns {
public:
    void add(const Components& inputs) {
        for (const auto& [name, component] : inputs) {
            const auto [at, fresh] = places_.try_emplace(name, Place{count_, component.directions.size()});
            if (fresh) count_ += component.directions.size();
            else if (at->second.size != component.directions.size())
                throw InvalidArgument(
                    fmt::format("input '{}' has {} directions in one value and {} in another; expected the same number",
                                name, at->second.size, component.directions.size()));
        }
    }
    [[nodiscard]] Index count() const { return count_; }

    template <class Row>
    void write(const Components& inputs, Row row) const {
        for (const auto& [name, component] : inputs) {
            const auto& place = places_.at(name);
            row.segment(place.first, place.size) = component.directions.matrix().transpose();
        }
    }

private:
    struct Place {
        Index first = 0, size = 0;
    };
    std::map<std::string_view, Place> places_;
    Index count_ = 0;
};

}  // namespace

Eigen::MatrixXd component_rows(const std::vector<const Components*>& values) {
    Columns columns;
    for (const auto* inputs : values) columns.add(*inputs);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Index>(values.size()), columns.count());
    for (std::size_t i = 0; i < values.size(); ++i) columns.write(*values[i], rows.row(static_cast<Index>(i)));
    return rows;
}

}  // namespace setae
