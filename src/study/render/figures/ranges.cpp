// SPDX-License-Identifier: GPL-3.0-or-later
#include "ranges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::figures {
namespace {

void require_length(const Panel& panel, const Series& series, const Array1D& values, const char* name,
                    bool may_be_empty) {
    if (values.size() == series.x.size() || (may_be_empty && values.size() == 0)) return;
    throw InvalidArgument(fmt::format("panel '{}', series '{}': {} values of x and {} of {}; expected as many",
                                      panel.title, series.label, series.x.size(), values.size(), name));
}

double scaled(const Axis& axis, double value) { return axis.logarithmic ? std::log10(value) : value; }
double unscaled(const Axis& axis, double value) { return axis.logarithmic ? std::pow(10.0, value) : value; }

void require_ends(const Axis& axis, const Range& range) {
    if (shows(axis, range.from) && shows(axis, range.to) && range.from < range.to) return;
    throw InvalidArgument(fmt::format("axis '{}' from {} to {}; expected finite ends in order{}", axis.quantity,
                                      range.from, range.to,
                                      axis.logarithmic ? ", positive on a logarithmic axis" : ""));
}

/// Ends of the visible data, scaled.
class Extent {
public:
    explicit Extent(const Axis& axis) : axis_(axis) {}

    void see(double value) {
        if (!shows(axis_, value)) return;
        least_ = std::min(least_, scaled(axis_, value));
        most_ = std::max(most_, scaled(axis_, value));
    }
    void see(const Array1D& values) {
        for (const double value : values) see(value);
    }

    [[nodiscard]] Range range() const {
        const auto categories = static_cast<double>(axis_.tick_labels.size());
        Range found = categories > 0.0 ? Range{-0.5, categories - 0.5} : with_margin();
        if (axis_.from) found.from = *axis_.from;
        if (axis_.to) found.to = *axis_.to;
        // data on one side of an end the user gave leave the other end to be chosen
        if (found.from >= found.to && !axis_.to) found.to = axis_.logarithmic ? 10.0 * found.from : found.from + 1.0;
        if (found.from >= found.to && !axis_.from) found.from = axis_.logarithmic ? 0.1 * found.to : found.to - 1.0;
        require_ends(axis_, found);
        return found;
    }

private:
    [[nodiscard]] Range with_margin() const {
        if (least_ > most_) return axis_.logarithmic ? Range{1.0, 10.0} : Range{0.0, 1.0};
        const double spread = most_ - least_;
        const double margin = spread > 1e-12 * std::max(std::abs(least_), std::abs(most_)) ? 0.05 * spread
                              : least_ == 0.0 || axis_.logarithmic                         ? 0.5
                                                                                           : 0.1 * std::abs(least_);
        return {unscaled(axis_, least_ - margin), unscaled(axis_, most_ + margin)};
    }

    const Axis& axis_;
    double least_ = std::numeric_limits<double>::infinity(), most_ = -least_;
};

}  // namespace

bool shows(const Axis& axis, double value) { return std::isfinite(value) && (!axis.logarithmic || value > 0.0); }

void require_drawable(const Panel& panel) {
    if (panel.map && !(panel.map->values.size() > 0 && panel.map->width > 0.0 && panel.map->height > 0.0 &&
                       std::isfinite(panel.map->width * panel.map->height)))
        throw InvalidArgument(
            fmt::format("panel '{}': a map of {} x {} values over {} x {}; expected values and a size > 0", panel.title,
                        panel.map->values.rows(), panel.map->values.cols(), panel.map->width, panel.map->height));
    for (const auto& series : panel.series) {
        require_length(panel, series, series.y, "y", series.mark == Mark::band);
        // both ends or none, and a band has them
        const bool ends = series.lower.size() > 0 || series.upper.size() > 0 || series.mark == Mark::band;
        require_length(panel, series, series.lower, "lower", !ends);
        require_length(panel, series, series.upper, "upper", !ends);
        require_length(panel, series, series.left, "left", series.right.size() == 0);
        require_length(panel, series, series.right, "right", series.left.size() == 0);
        if (!series.names.empty() && series.names.size() != static_cast<std::size_t>(series.x.size()))
            throw InvalidArgument(
                fmt::format("panel '{}', series '{}': {} values of x and {} names; expected as many or none",
                            panel.title, series.label, series.x.size(), series.names.size()));
    }
}

Range value_range(const HeatMap& map) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (Index i = 0; i < map.values.size(); ++i) {
        const double value = map.values.data()[i];
        if (!std::isfinite(value)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    if (least > most) {
        least = 0.0;
        most = 1.0;
    }
    if (least == most) most = least + 1.0;
    Range range{map.values_axis.from.value_or(least), map.values_axis.to.value_or(most)};
    require_ends(map.values_axis, range);
    return range;
}

Range x_range(const Panel& panel) {
    if (panel.map) return {0.0, panel.map->width};
    Extent extent(panel.x);
    for (const auto& series : panel.series)
        for (const auto* values : {&series.x, &series.left, &series.right}) extent.see(*values);
    return extent.range();
}

Range y_range(const Panel& panel) {
    if (panel.map) return {0.0, panel.map->height};
    Extent extent(panel.y);
    for (const auto& series : panel.series)
        for (const auto* values : {&series.y, &series.lower, &series.upper}) extent.see(*values);
    for (const double height : panel.horizontal_lines) extent.see(height);
    return extent.range();
}

double share(const Axis& axis, const Range& range, double value) {
    return (scaled(axis, value) - scaled(axis, range.from)) / (scaled(axis, range.to) - scaled(axis, range.from));
}

Series clipped_band(const Panel& panel, const Series& band, const Range& x, const Range& y) {
    constexpr int steps = 64;
    std::vector<double> across, middle, lower, upper;
    const auto value = [](const Array1D& values, Index i) { return values.size() > 0 ? values[i] : undefined; };
    const auto seen = [&](Index i) {
        return shows(panel.x, band.x[i]) && shows(panel.y, band.upper[i]) && std::isfinite(band.lower[i]);
    };
    const auto inside = [](const Range& range, double at) { return at >= range.from && at <= range.to; };
    const auto held = [&](double at) { return std::clamp(at, y.from, y.to); };
    const auto add = [&](double at, double height, double from, double to) {
        across.push_back(at);
        middle.push_back(height);
        lower.push_back(from);
        upper.push_back(to);
    };
    for (Index i = 0; i < band.x.size(); ++i) {
        if (!seen(i)) {
            add(undefined, undefined, undefined, undefined);
            continue;
        }
        const auto whole = [&](Index k) {
            return inside(x, band.x[k]) && inside(y, band.lower[k]) && inside(y, band.upper[k]);
        };
        if (i > 0 && seen(i - 1) && !(whole(i - 1) && whole(i)))
            for (int step = 1; step < steps; ++step) {
                const double way = static_cast<double>(step) / steps;
                const auto between = [way](const Axis& axis, double a, double b) {
                    return unscaled(axis, (1.0 - way) * scaled(axis, a) + way * scaled(axis, b));
                };
                const double at = between(panel.x, band.x[i - 1], band.x[i]);
                // an end a logarithmic axis cannot show counts as at its foot
                const auto foot = [&](double end) { return shows(panel.y, end) ? end : y.from; };
                if (inside(x, at))
                    add(at, between(panel.y, value(band.y, i - 1), value(band.y, i)),
                        held(between(panel.y, foot(band.lower[i - 1]), foot(band.lower[i]))),
                        held(between(panel.y, band.upper[i - 1], band.upper[i])));
            }
        if (inside(x, band.x[i])) add(band.x[i], value(band.y, i), held(band.lower[i]), held(band.upper[i]));
    }
    const auto array = [](const std::vector<double>& values) {
        return Array1D(Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size())));
    };
    Series clipped = band;
    clipped.x = array(across);
    clipped.lower = array(lower);
    clipped.upper = array(upper);
    if (band.y.size() > 0) clipped.y = array(middle);
    return clipped;
}

Corner emptiest_corner(const Panel& panel, const Range& x, const Range& y, double width, double height) {
    std::array<double, 4> hidden{};
    const auto see = [&](double across, double up, double weight) {
        if (!(across >= 0.0 && across <= 1.0 && up >= 0.0 && up <= 1.0)) return;
        const bool right = across > 1.0 - width, left = across<width, top = up> 1.0 - height, bottom = up < height;
        hidden[0] += right && top ? weight : 0.0;
        hidden[1] += left && top ? weight : 0.0;
        hidden[2] += right && bottom ? weight : 0.0;
        hidden[3] += left && bottom ? weight : 0.0;
    };
    constexpr int steps = 16;
    for (const auto& series : panel.series) {
        if (series.x.size() == 0) continue;
        const double weight = 1.0 / static_cast<double>(series.x.size());
        for (const auto* values : {&series.y, &series.lower, &series.upper})
            for (Index i = 0; i < values->size(); ++i) {
                if (!shows(panel.x, series.x[i]) || !shows(panel.y, (*values)[i])) continue;
                const double across = share(panel.x, x, series.x[i]), up = share(panel.y, y, (*values)[i]);
                see(across, up, weight);
                if (series.mark == Mark::points || i == 0 || !shows(panel.x, series.x[i - 1]) ||
                    !shows(panel.y, (*values)[i - 1]))
                    continue;
                const double across_before = share(panel.x, x, series.x[i - 1]),
                             up_before = share(panel.y, y, (*values)[i - 1]);
                for (int step = 1; step < steps; ++step) {
                    const double way = static_cast<double>(step) / steps;
                    see(across_before + way * (across - across_before), up_before + way * (up - up_before),
                        weight / steps);
                }
            }
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i < hidden.size(); ++i)
        if (hidden[i] < hidden[best]) best = i;
    return static_cast<Corner>(best);
}

}  // namespace setae::figures
