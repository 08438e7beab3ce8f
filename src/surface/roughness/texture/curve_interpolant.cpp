// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_interpolant.hpp"

#include <algorithm>
#include <cmath>

#include "setae/numerics/bracketing.hpp"

namespace setae::texture {
namespace {

constexpr double largest_step = 1.0 / 1024.0;

/// Nodes with additional ones between those whose ratios differ by more than the largest step.
std::vector<double> refined(const std::vector<double>& nodes, const CurveSums& sums, double narrowest) {
    std::vector<double> result;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
        const auto at = static_cast<Index>(k);
        const double drop = (sums.above[at] - sums.above[at + 1]) / sums.weight, width = nodes[k + 1] - nodes[k];
        const int parts = drop <= largest_step || width < narrowest
                              ? 1
                              : std::min(256, static_cast<int>(std::ceil(2.0 * drop / largest_step)));
        for (int part = 0; part < parts; ++part) result.push_back(nodes[k] + width * part / parts);
    }
    result.push_back(nodes.back());
    return result;
}

/// ∫_s^1 f by three points, exact for polynomials of degree five.
template <class Function>
double integral_to_one(double s, Function f) {
    constexpr double outer = 0.774596669241483377;
    const double half = 0.5 * (1.0 - s), middle = 0.5 * (1.0 + s);
    return half / 9.0 * (5.0 * f(middle - outer * half) + 8.0 * f(middle) + 5.0 * f(middle + outer * half));
}

double squared(double x) { return x * x; }

}  // namespace

CurveInterpolant::CurveInterpolant(const Elements& elements, parallel::Threads threads) {
    const auto range = elements.range();
    const double span = range.highest - range.lowest;
    constexpr int first_parts = 512, max_passes = 5;
    for (int k = 0; k < first_parts && span > 0.0; ++k) nodes_.push_back(range.lowest + span * k / first_parts);
    nodes_.push_back(range.highest);
    const auto sums_at = [&](const std::vector<double>& heights, Volumes volumes) {
        return sum_curve(elements,
                         HeightLocator(Eigen::Map<const Array1D>(heights.data(), static_cast<Index>(heights.size()))),
                         volumes, threads);
    };
    // the first pass is usually needed only to place nodes
    sums_ = sums_at(nodes_, Volumes::no);
    for (int pass = 1; pass < max_passes; ++pass) {
        auto more = refined(nodes_, sums_, 1e-9 * span);
        if (more.size() == nodes_.size()) break;
        nodes_ = std::move(more);
        sums_ = sums_at(nodes_, Volumes::yes);
    }
    if (sums_.volume.size() == 0) sums_ = sums_at(nodes_, Volumes::yes);
    const double mean = nodes_.front() + sums_.moment / sums_.weight;
    const auto n = nodes_.size();
    for (std::size_t k = 0; k < n; ++k) {
        heights_.push_back(nodes_[k] - mean);
        ratios_.push_back(sums_.above[static_cast<Index>(k)] / sums_.weight);
        volumes_.push_back(sums_.volume[static_cast<Index>(k)] / sums_.weight);
    }
    squares_.assign(n, 0.0);
    bulge_.assign(n, 0.0);
    for (std::size_t k = n - 1; k-- > 0;) {
        const double width = heights_[k + 1] - heights_[k];
        bulge_[k] = 6.0 * ((volumes_[k] - volumes_[k + 1]) / width - 0.5 * (ratios_[k] + ratios_[k + 1]));
        squares_[k] = squares_[k + 1] + width * integral_to_one(0.0, [&](double s) { return squared(ratio_in(k, s)); });
    }
}

std::size_t CurveInterpolant::interval_of(double height) const {
    const auto above = std::upper_bound(heights_.begin() + 1, heights_.end() - 1, height) - heights_.begin();
    return static_cast<std::size_t>(above - 1);
}

double CurveInterpolant::ratio_in(std::size_t k, double s) const {
    return (1.0 - s) * ratios_[k] + s * ratios_[k + 1] + bulge_[k] * s * (1.0 - s);
}

double CurveInterpolant::ratio(double height) const {
    if (height <= heights_.front()) return 1.0;
    if (height >= heights_.back()) return height > heights_.back() ? 0.0 : ratios_.back();
    const auto k = interval_of(height);
    return ratio_in(k, (height - heights_[k]) / (heights_[k + 1] - heights_[k]));
}

double CurveInterpolant::height(double ratio) const {
    const auto below =
        std::lower_bound(ratios_.begin(), ratios_.end(), ratio, [](double r, double wanted) { return r >= wanted; }) -
        ratios_.begin();
    if (below == 0) return heights_.front();
    if (below == static_cast<std::ptrdiff_t>(ratios_.size())) return heights_.back();
    const auto k = static_cast<std::size_t>(below - 1);
    const double place = numerics::bisected([&](double s) { return ratio_in(k, s) >= ratio; }, 0.0, 1.0, 54).first;
    return heights_[k] + place * (heights_[k + 1] - heights_[k]);
}

double CurveInterpolant::volume(double height) const {
    if (height <= heights_.front()) return volumes_.front() + (heights_.front() - height);
    if (height >= heights_.back()) return 0.0;
    const auto k = interval_of(height);
    const double width = heights_[k + 1] - heights_[k];
    return volumes_[k + 1] +
           width * integral_to_one((height - heights_[k]) / width, [&](double s) { return ratio_in(k, s); });
}

double CurveInterpolant::void_volume(double height) const { return std::max(0.0, volume(height) + height); }

double CurveInterpolant::square(double height) const {
    if (height <= heights_.front()) return squares_.front() + (heights_.front() - height);
    if (height >= heights_.back()) return 0.0;
    const auto k = interval_of(height);
    const double width = heights_[k + 1] - heights_[k];
    return squares_[k + 1] +
           width * integral_to_one((height - heights_[k]) / width, [&](double s) { return squared(ratio_in(k, s)); });
}

}  // namespace setae::texture
