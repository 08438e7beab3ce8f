// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/persson/stress_diffusion.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::persson {
namespace {

constexpr Index cells = 700;
constexpr double cell_width = 0.02;       ///< width in y = (p + σ_a)/√V
constexpr double largest_step = 0.025;    ///< step of ln V
constexpr double largest_shift = 0.2;     ///< shift of the end, divided by √V
constexpr double first_distance2 = 30.0;  ///< (p_0 + σ_a)²/V above which erfc is 0 within rounding: no area is lost

/// x/(exp(x) − 1).
double bernoulli(double x) { return std::abs(x) < 1e-10 ? 1.0 - 0.5 * x : x / std::expm1(x); }

/// Area in each cell of y, and the steps it takes in ln V.
class Cells {
public:
    /// The solution for a constant σ_a, (p_0 + σ_a)/√V away from the end.
    explicit Cells(double distance) : area_(cells) {
        for (Index j = 0; j < cells; ++j) {
            const double y = middle(j);
            area_[j] = cell_width * std::exp(-0.5 * (y - distance) * (y - distance)) *
                       -std::expm1(-2.0 * y * distance) / std::sqrt(2.0 * pi);
        }
        area_ *= std::erf(distance / std::sqrt(2.0)) / area_.sum();
    }

    [[nodiscard]] double sum() const { return area_.sum(); }
    [[nodiscard]] const Array1D& areas() const { return area_; }
    [[nodiscard]] static double middle(Index j) { return (static_cast<double>(j) + 0.5) * cell_width; }

    /// One step of ln V while the end moves away at `drift` = dσ_a/d ln V/√V.
    void step(double length, double drift) {
        // flux between cells j − 1 and j: rises_[j] area_[j − 1] − falls_[j] area_[j]; none beyond the last
        Array1D rises = Array1D::Zero(cells + 1), falls = Array1D::Zero(cells + 1);
        const double rate = 0.5 / (cell_width * cell_width);
        falls[0] = 2.0 * rate * bernoulli(drift * cell_width);
        for (Index j = 1; j < cells; ++j) {
            const double speed = drift - 0.5 * static_cast<double>(j) * cell_width;
            const double ratio = 2.0 * speed * cell_width;
            rises[j] = rate * bernoulli(-ratio);
            falls[j] = rate * bernoulli(ratio);
        }
        solve(rises, falls, 0.5 * length);
    }

private:
    /// (1 − hL) new = (1 + hL) old by Thomas' elimination.
    void solve(const Array1D& rises, const Array1D& falls, double half) {
        Array1D right(cells), upper(cells);
        double above = 0.0, result = 0.0;
        for (Index j = 0; j < cells; ++j) {
            const double loss = falls[j] + rises[j + 1];
            const double from_below = j > 0 ? rises[j] * area_[j - 1] : 0.0;
            const double from_above = j + 1 < cells ? falls[j + 1] * area_[j + 1] : 0.0;
            const double value = area_[j] + half * (from_below + from_above - loss * area_[j]);
            const double lower = j > 0 ? -half * rises[j] : 0.0;
            const double pivot = 1.0 + half * loss - lower * above;
            above = j + 1 < cells ? -half * falls[j + 1] / pivot : 0.0;
            result = (value - lower * result) / pivot;
            upper[j] = above;
            right[j] = result;
        }
        for (Index j = cells - 2; j >= 0; --j) right[j] -= upper[j] * right[j + 1];
        area_ = right;
    }

    Array1D area_;
};

void require(const ArrayView1D& variance, const ArrayView1D& stress) {
    if (variance.size() != stress.size() || variance.size() == 0)
        throw InvalidArgument(fmt::format("{} pressure variances and {} detachment stresses; expected as many of both",
                                          variance.size(), stress.size()));
    if (variance[0] != 0.0)
        throw InvalidArgument(fmt::format("the first pressure variance is {} Pa2; expected 0", variance[0]));
    for (Index i = 1; i < variance.size(); ++i)
        if (!(variance[i] >= variance[i - 1]) || !(variance[i] > 0.0))
            throw InvalidArgument(fmt::format("pressure variance {} is {} Pa2 after {} Pa2; expected a larger one", i,
                                              variance[i], variance[i - 1]));
}

}  // namespace

StressDiffusion stress_diffusion(const ArrayView1D& pressure_variance, const ArrayView1D& detachment_stress,
                                 double mean_pressure) {
    require(pressure_variance, detachment_stress);
    const Index n = pressure_variance.size();
    StressDiffusion result{.area_fraction = Array1D::Zero(n)};
    const auto distance = [&](Index i) { return mean_pressure + detachment_stress[i]; };
    Index first = 0;
    const auto is_far = [&](Index i) {
        return distance(i) > 0.0 && distance(i) * distance(i) >= first_distance2 * pressure_variance[i];
    };
    while (first < n && is_far(first)) result.area_fraction[first++] = 1.0;
    if (first == n || !(distance(first) > 0.0)) return result;
    Cells state(distance(first) / std::sqrt(pressure_variance[first]));
    result.area_fraction[first] = state.sum();
    for (Index i = first + 1; i < n; ++i) {
        const double length = std::log(pressure_variance[i] / pressure_variance[i - 1]);
        const double moved = detachment_stress[i] - detachment_stress[i - 1];
        const double shift = std::abs(moved) / std::sqrt(pressure_variance[i - 1]);
        const double steps = std::ceil(std::max(length / largest_step, shift / largest_shift));
        for (double k = 0.0; k < steps && length > 0.0; ++k) {
            const double part = (k + 0.5) / steps;
            const double width = std::sqrt(pressure_variance[i - 1]) * std::exp(0.5 * length * part);
            state.step(length / steps, moved / length / width);
        }
        result.area_fraction[i] = state.sum();
    }
    const double width = std::sqrt(pressure_variance[n - 1]);
    result.pressure =
        Array1D::NullaryExpr(cells, [&](Index j) { return Cells::middle(j) * width - detachment_stress[n - 1]; });
    result.density = state.areas() / (cell_width * width);
    return result;
}

}  // namespace setae::persson
