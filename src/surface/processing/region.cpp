// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "order_statistic.hpp"
#include "pipeline/step_record.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::processing {
namespace {

using numerics::for_each_row;

using topography::HeightMap;
using topography::LineScan;
using topography::Mask;
using topography::Profile;

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Positions of the points of a measurement: rows along x, columns along y; a line is one column.
struct Places {
    Index rows, columns;
    std::array<double, 2> step;  ///< pixel size
    const double* positions;     ///< of polylines, otherwise null
    const double* heights;
    bool line;
    std::string label;

    [[nodiscard]] double x(Index i) const { return positions ? positions[i] : static_cast<double>(i) * step[0]; }
    [[nodiscard]] double y(Index j) const { return static_cast<double>(j) * step[1]; }
    [[nodiscard]] ComputedRows height_rows() const {
        const auto at = [this](Index i, Index j) { return heights[i * columns + j]; };
        return {rows, columns, [this](Index i, double* values) { std::copy_n(heights + i * columns, columns, values); },
                at};
    }
};

Places places_of(const HeightMap& map) {
    return {map.heights.rows(),
            map.heights.cols(),
            map.pixel_size(),
            nullptr,
            map.heights.data(),
            false,
            topography::label(map.metadata)};
}
Places places_of(const LineScan& scan) {
    return {scan.heights.size(), 1,    {scan.pixel_size(), 1.0},        nullptr,
            scan.heights.data(), true, topography::label(scan.metadata)};
}
Places places_of(const Profile& profile) {
    return {profile.positions.size(),           1, {1.0, 1.0}, profile.positions.data(), profile.heights.data(), true,
            topography::label(profile.metadata)};
}

struct Limits {
    double lower, upper;
    [[nodiscard]] bool hold(double value) const { return value >= lower && value <= upper; }
};

/// `slack` widens a range of positions, so a point on its end is not lost by rounding.
Limits limits_of(const Range& range, const char* what, double slack) {
    const Limits limits{range.from.value_or(-unlimited), range.to.value_or(unlimited)};
    if (!(limits.lower <= limits.upper))
        throw InvalidArgument(
            fmt::format("range of {} from {} to {}; expected from <= to", what, limits.lower, limits.upper));
    return {limits.lower - slack, limits.upper + slack};
}

constexpr double rounding_of_positions = 1e-9;  // of a pixel

/// Selects the points of one outline.
struct Chooser {
    const Places& places;
    Mask& mask;
    parallel::Threads threads;

    void require_map(const char* shape) const {
        if (places.line)
            throw InvalidArgument(fmt::format(
                "{}: {} cannot be applied to a line; expected a range of x (rectangle FROM to TO), heights or "
                "percentiles",
                places.label, shape));
    }

    /// chosen(i, j) for every point.
    template <class Chosen>
    void choose(const Chosen& chosen) const {
        for_each_row(places.rows, places.columns, threads, [&](Index i) {
            for (Index j = 0; j < places.columns; ++j) mask(i, j) = chosen(i, j) ? 1 : 0;
        });
    }

    void operator()(const Rectangle& rectangle) const {
        if (rectangle.y.from || rectangle.y.to) require_map("a range of y");
        const auto x = limits_of(rectangle.x, "x", places.positions ? 0.0 : rounding_of_positions * places.step[0]),
                   y = limits_of(rectangle.y, "y", rounding_of_positions * places.step[1]);
        choose([&](Index i, Index j) { return x.hold(places.x(i)) && y.hold(places.y(j)); });
    }

    void operator()(const Ellipse& ellipse) const {
        require_map("an ellipse");
        if (!(ellipse.semi_axes[0] > 0.0 && ellipse.semi_axes[1] > 0.0))
            throw InvalidArgument(fmt::format("ellipse with semi-axes {} and {} m; expected lengths > 0",
                                              ellipse.semi_axes[0], ellipse.semi_axes[1]));
        const double cosine = std::cos(ellipse.angle), sine = std::sin(ellipse.angle);
        choose([&](Index i, Index j) {
            const double x = places.x(i) - ellipse.centre[0], y = places.y(j) - ellipse.centre[1];
            return std::hypot((x * cosine + y * sine) / ellipse.semi_axes[0],
                              (y * cosine - x * sine) / ellipse.semi_axes[1]) <= 1.0 + rounding_of_positions;
        });
    }

    /// Row by row between the crossings of its x with the sides of the polygon.
    void operator()(const Polygon& polygon) const {
        require_map("a polygon");
        const auto corners = polygon.corners.size();
        if (corners < 3) throw InvalidArgument(fmt::format("polygon with {} corners; expected at least 3", corners));
        for_each_row(places.rows, places.columns, threads, [&](Index i) {
            const double x = places.x(i);
            std::vector<double> crossings;
            for (std::size_t k = 0; k < corners; ++k) {
                const auto& a = polygon.corners[k];
                const auto& b = polygon.corners[(k + 1) % corners];
                if ((a[0] <= x) != (b[0] <= x)) crossings.push_back(a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]));
            }
            std::sort(crossings.begin(), crossings.end());
            mask.row(i).setZero();
            for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
                for (Index j = std::max<Index>(0, static_cast<Index>(std::ceil(crossings[k] / places.step[1])));
                     j < places.columns && places.y(j) <= crossings[k + 1]; ++j)
                    mask(i, j) = 1;
        });
    }

    void within(const Limits& limits) const {
        choose([&](Index i, Index j) { return limits.hold(places.heights[i * places.columns + j]); });
    }

    void operator()(const HeightRange& range) const { within(limits_of(range.heights, "heights", 0.0)); }

    void operator()(const PercentileRange& range) const {
        const auto percentiles = limits_of(range.percentiles, "percentiles", 0.0);
        if ((range.percentiles.from && !(percentiles.lower >= 0.0)) ||
            (range.percentiles.to && !(percentiles.upper <= 100.0)))
            throw InvalidArgument(
                fmt::format("percentiles {} to {}; expected 0 … 100", percentiles.lower, percentiles.upper));
        const auto at = [&](const std::optional<double>& percentile, double open) {
            if (!percentile) return open;
            const auto found = quantile(places.height_rows(), *percentile / 100.0, threads);
            if (!found)
                throw UndefinedDataError(
                    fmt::format("{}: no height is defined, so that there are no percentiles of heights", places.label));
            return *found;
        };
        within({at(range.percentiles.from, -unlimited), at(range.percentiles.to, unlimited)});
    }
};

/// Selected points and those within `by` rows and columns of one.
Mask grown(const Mask& mask, Index by) {
    if (by < 0) throw InvalidArgument(fmt::format("grow {} pixels; expected a number >= 0", by));
    if (by == 0) return mask;
    const auto along = [by](Index count, auto&& source, auto&& target) {
        Index left = 0;  // remaining reach of the last selected point
        for (Index k = 0; k < count; ++k) {
            if (source(k)) left = by + 1;
            if (left > 0) {
                target(k);
                --left;
            }
        }
        left = 0;
        for (Index k = count - 1; k >= 0; --k) {
            if (source(k)) left = by + 1;
            if (left > 0) {
                target(k);
                --left;
            }
        }
    };
    Mask wider = mask;
    for (Index i = 0; i < mask.rows(); ++i)
        along(
            mask.cols(), [&](Index j) { return mask(i, j); }, [&](Index j) { wider(i, j) = 1; });
    Mask both = wider;
    for (Index j = 0; j < mask.cols(); ++j)
        along(
            mask.rows(), [&](Index i) { return wider(i, j); }, [&](Index i) { both(i, j) = 1; });
    return both;
}

Mask union_of(const std::vector<Shape>& shapes, const Places& places, parallel::Threads threads) {
    Mask all = Mask::Zero(places.rows, places.columns);
    for (const auto& shape : shapes) {
        Mask mask(places.rows, places.columns);
        std::visit(Chooser{places, mask, threads}, shape.outline);
        all = all.max(grown(mask, shape.grow));
    }
    return all;
}

Mask mask_at(const Region& region, const Places& places, parallel::Threads threads) {
    Mask mask = region.include.empty() ? Mask(Mask::Ones(places.rows, places.columns))
                                       : union_of(region.include, places, threads);
    if (!region.exclude.empty()) mask = mask.min(std::uint8_t{1} - union_of(region.exclude, places, threads));
    return mask;
}

/// A polyline without the selected points of a mask.
void leave_out(Profile& profile, const Mask& chosen) {
    Index kept = 0;
    const bool errors = profile.standard_error.size() > 0;
    for (Index i = 0; i < profile.positions.size(); ++i) {
        if (chosen(i, 0)) continue;
        profile.positions[kept] = profile.positions[i];
        profile.heights[kept] = profile.heights[i];
        if (errors) profile.standard_error[kept] = profile.standard_error[i];
        ++kept;
    }
    profile.positions.conservativeResize(kept);
    profile.heights.conservativeResize(kept);
    if (errors) profile.standard_error.conservativeResize(kept);
}

template <class Uniform>
void leave_out(Uniform& uniform, const Mask& chosen) {
    for (Index k = 0; k < chosen.size(); ++k)
        if (chosen.data()[k]) uniform.heights.data()[k] = undefined;
}

}  // namespace

Mask mask_of(const Region& region, const HeightMap& map, parallel::Threads threads) {
    return mask_at(region, places_of(map), threads);
}
Mask mask_of(const Region& region, const LineScan& scan, parallel::Threads threads) {
    return mask_at(region, places_of(scan), threads);
}
Mask mask_of(const Region& region, const Profile& profile, parallel::Threads threads) {
    return mask_at(region, places_of(profile), threads);
}

Processed apply(const MaskOut& step, topography::Measurement measurement, parallel::Threads threads) {
    if (step.region.everything())
        throw InvalidArgument(
            "mask_out needs a region, and none is given; expected one, such as region=\"include heights "
            "above 20 nm\"");
    StepRecord record{std::string(step_name(step)), {}, {}};
    std::visit(
        [&](auto& m) {
            const auto chosen = mask_of(step.region, m, threads);
            const auto defined = (!m.heights.isNaN()).count();
            leave_out(m, chosen);
            const auto left = (!m.heights.isNaN()).count();
            if (left == 0)
                throw UndefinedDataError(fmt::format("{}: the region of mask_out contains all defined heights",
                                                     topography::label(m.metadata)));
            record.numbers.push_back(recorded_count("masked_points", defined - left));
            record.numbers.push_back(recorded(
                "masked_share", "", static_cast<double>(defined - left) / static_cast<double>(chosen.size()), "1"));
        },
        measurement);
    return {std::move(measurement), std::move(record)};
}

}  // namespace setae::processing
