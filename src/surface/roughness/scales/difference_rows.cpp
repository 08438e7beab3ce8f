// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "setae/core/constants.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"

namespace setae::scales {
namespace {

constexpr std::size_t max_taps = 6;

/// A height in a difference, relative to the point of the difference.
struct Tap {
    Index offset = 0;
    double weight = 0.0;
};

/// Contributions in addition to the height at the point, whose weight is minus the sum of all others.
struct Taps {
    std::vector<Tap> others;
    Index before = 0, after = 0;  ///< points used on either side
};

Taps taps_of(int order, double step) {
    Taps taps;
    for (const auto& point : stencil(order)) {
        if (point.place == 0) continue;
        const double place = point.place * step;
        const double nearest = std::round(place);
        const bool whole = std::abs(place - nearest) <= 1e-9 * std::max(1.0, std::abs(place));
        const double floor = whole ? nearest : std::floor(place);
        const double share = whole ? 0.0 : place - floor;
        const auto offset = static_cast<Index>(floor);
        taps.others.push_back({offset, point.coefficient * (1.0 - share)});
        if (!whole) taps.others.push_back({offset + 1, point.coefficient * share});
    }
    for (const auto& tap : taps.others) {
        taps.before = std::max(taps.before, -tap.offset);
        taps.after = std::max(taps.after, tap.offset);
    }
    return taps;
}

using Sources = std::array<const double*, max_taps>;
using Weights = std::array<double, max_taps>;

template <std::size_t count>
void add_up(const double* base, const Sources& sources, const Weights& weights, Index n, double* out) {
    for (Index j = 0; j < n; ++j) {
        const double at = base[j];
        double sum = weights[0] * (sources[0][j] - at);
        for (std::size_t m = 1; m < count; ++m) sum += weights[m] * (sources[m][j] - at);
        out[j] = sum;
    }
}

using Adder = void (*)(const double*, const Sources&, const Weights&, Index, double*);
constexpr std::array<Adder, max_taps> adders{add_up<1>, add_up<2>, add_up<3>, add_up<4>, add_up<5>, add_up<6>};

}  // namespace

std::vector<StencilPoint> stencil(int order) {
    if (order == 1) return {{0, -1.0}, {1, 1.0}};
    if (order == 2) return {{0, -2.0}, {-1, 1.0}, {1, 1.0}};
    return {{0, 3.0}, {-1, -1.0}, {1, -3.0}, {2, 1.0}};
}

DifferenceRows linear_differences(const Field& field, Running running, int order, double distance) {
    const double step = distance / order;
    const auto taps = taps_of(order, step / field.step);
    const double scale = 1.0 / std::pow(step, order);
    Weights weights{};
    for (std::size_t m = 0; m < taps.others.size(); ++m) weights[m] = taps.others[m].weight * scale;
    const auto add = adders[taps.others.size() - 1];

    DifferenceRows rows{0, field.rows, 0, field.columns, {}};
    Index& first = running == Running::across_rows ? rows.first_row : rows.first_column;
    Index& end = running == Running::across_rows ? rows.end_row : rows.end_column;
    if (!field.periodic) {
        first = taps.before;
        end = std::max(first, end - taps.after);
    }
    if (running == Running::across_rows) {
        rows.fill = [=](Index row, double* out) {
            Sources sources{};
            for (std::size_t m = 0; m < taps.others.size(); ++m) {
                const Index other = ((row + taps.others[m].offset) % field.rows + field.rows) % field.rows;
                sources[m] = field.heights + other * field.columns;
            }
            add(field.heights + row * field.columns, sources, weights, field.columns, out);
        };
        return rows;
    }
    const Index count = end - first;
    rows.fill = [=](Index row, double* out) {
        const double* base = field.heights + row * field.columns + first;
        thread_local fourier::Buffer<double> continued;
        if (field.periodic) {
            continued.resize(static_cast<std::size_t>(taps.before + field.columns + taps.after));
            for (Index j = 0; j < static_cast<Index>(continued.size()); ++j)
                continued[static_cast<std::size_t>(j)] =
                    base[((j - taps.before) % field.columns + field.columns) % field.columns];
            base = continued.data() + taps.before;
        }
        Sources sources{};
        for (std::size_t m = 0; m < taps.others.size(); ++m) sources[m] = base + taps.others[m].offset;
        add(base, sources, weights, count, out);
    };
    return rows;
}

DifferenceRows fourier_differences(const Field& field, int order, double distance) {
    struct Transforms {
        fourier::RealTransform forward;
        fourier::InverseRealTransform back;
        explicit Transforms(Index n) : forward(n), back(n) {}
    };
    const auto transforms = std::make_shared<Transforms>(field.columns);
    const double step = distance / order;
    const auto n = static_cast<double>(field.columns);
    std::vector<fourier::Complex> symbol(static_cast<std::size_t>(transforms->forward.modes()));
    for (std::size_t k = 0; k < symbol.size(); ++k)
        for (const auto& point : stencil(order))
            symbol[k] += point.coefficient *
                         std::polar(1.0, 2.0 * pi * static_cast<double>(k) * point.place * step / (field.step * n));
    const double scale = 1.0 / (std::pow(step, order) * n);
    for (auto& value : symbol) value *= scale;
    symbol[0] = 0.0;
    DifferenceRows rows{0, field.rows, 0, field.columns, {}};
    rows.fill = [=](Index row, double* out) {
        thread_local fourier::Buffer<double> line;
        thread_local fourier::Buffer<fourier::Complex> modes;
        line.resize(static_cast<std::size_t>(field.columns));
        modes.resize(symbol.size());
        const double* heights = field.heights + row * field.columns;
        for (std::size_t j = 0; j < line.size(); ++j) line[j] = heights[j] - heights[0];
        transforms->forward.forward(line.data(), modes.data());
        for (std::size_t k = 0; k < symbol.size(); ++k) modes[k] *= symbol[k];
        transforms->back.apply(modes.data(), line.data());
        std::copy(line.begin(), line.end(), out);
    };
    return rows;
}

}  // namespace setae::scales
