// SPDX-License-Identifier: GPL-3.0-or-later
#include "elements.hpp"

#include <limits>

#include "setae/core/errors.hpp"

namespace setae::texture {

Elements::Elements(const MeasurementView& measurement, Between between) : measurement_(measurement), between_(between) {
    constexpr Index max_blocks = 64;
    if (const auto* profile = measurement.as<topography::Profile>()) {
        if (between == Between::nothing)
            throw InvalidArgument(
                topography::label(profile->metadata) +
                ": points of a polyline have no weight of their own; use its segments (Between::linear)");
        topography::validate(*profile);
    }
    Index least = 1;
    if (between == Between::nothing) {
        count_ = measurement.visit([](const auto& m) { return m.heights.size(); });
        least = 1 << 14;
    } else if (const auto* map = measurement.as<topography::HeightMap>()) {
        count_ = map->periodic ? map->heights.rows() : map->heights.rows() - 1;
        least = 32;
    }
    block_size_ = std::max(least, (count_ + max_blocks - 1) / max_blocks);
    blocks_ = static_cast<std::size_t>((count_ + block_size_ - 1) / block_size_);
}

Range Elements::range() const {
    Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    measurement_.visit([&range](const auto& m) {
        const double* h = m.heights.data();
        for (Index i = 0; i < m.heights.size(); ++i) {
            range.lowest = h[i] < range.lowest ? h[i] : range.lowest;
            range.highest = h[i] > range.highest ? h[i] : range.highest;
        }
    });
    if (!(range.lowest <= range.highest))
        throw UndefinedDataError(topography::label(measurement_.metadata()) + ": no height is defined");
    return range;
}

void Elements::require_weight(double weight) const {
    if (!(weight > 0.0))
        throw UndefinedDataError(
            topography::label(measurement_.metadata()) +
            ": no two neighbouring heights (for a map: three) are defined; fill undefined heights first");
}

}  // namespace setae::texture
