// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_regression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "moment_field.hpp"
#include "setae/core/extent.hpp"

namespace setae::processing {
namespace {

constexpr Index regression_columns_per_block = 128;
constexpr std::size_t max_terms = 6;
/// A pivot below this share of its diagonal: the nearby points are on a curve on which the polynomial vanishes.
constexpr double smallest_pivot = 1e-9;

struct Census {
    double centre = 0.0;  ///< mean of the defined heights
    bool complete = true;
};

Census census(const ArrayView2D& heights) {
    double sum = 0.0;
    Index defined = 0;
    for (Index i = 0; i < heights.rows(); ++i) {
        double row = 0.0;
        for (Index j = 0; j < heights.cols(); ++j) {
            const double height = heights(i, j);
            const bool there = !std::isnan(height);
            row += there ? height : 0.0;
            defined += there;
        }
        sum += row;
    }
    return {defined > 0 ? sum / static_cast<double>(defined) : 0.0, defined == heights.size()};
}

/// Sums of the Gaussian: for a complete map they are products of those along both directions.
Array2D sums_of_one(const GaussianAxis& axis, Index orders) {
    const GaussianAxis point(1, 0.0, false, orders);
    const auto one = [](Index, Index, Index count, double* values) { std::fill(values, values + count, 1.0); };
    const MomentField field(point, axis, powers_up_to(orders, 0, orders), one, {1});
    Array2D sums(orders + 1, axis.points);
    for (Index k = 0; k <= orders; ++k) field.moments(0, 0, axis.points, extent(k), &sums(k, 0));
    return sums;
}

/// The weights around the points of a line of a complete map, as needed for a fitted line.
struct Levers {
    Array1D inverse;  ///< 1/sum of weights
    Array1D mean;     ///< of the coordinate
    Array1D lever;    ///< (point − mean)/variance of the coordinate; 0 if nothing is fitted along this direction

    Levers(const Array2D& sums, const Array1D& coordinate, bool fitted)
        : inverse(1.0 / sums.row(0).transpose()), mean(Array1D::Zero(sums.cols())), lever(Array1D::Zero(sums.cols())) {
        if (!fitted) return;
        mean = sums.row(1).transpose() * inverse;
        const Array1D variance = sums.row(2).transpose() * inverse - mean.square();
        lever = (variance > smallest_pivot).select((coordinate - mean) / variance, 0.0);
    }
};

/// Weighted least squares of a polynomial about a reference, evaluated at a point.
class LocalFit {
public:
    LocalFit(Index order, Index max_x, Index max_y)
        : terms_(powers_up_to(order, max_x, max_y)),
          sums_(powers_up_to(2 * order, max_x > 0 ? 2 * order : 0, max_y > 0 ? 2 * order : 0)) {
        for (const Powers& a : terms_)
            for (const Powers& b : terms_)
                products_.push_back(
                    extent(std::find_if(sums_.begin(), sums_.end(),
                                        [&](const Powers& s) { return s.x == a.x + b.x && s.y == a.y + b.y; }) -
                           sums_.begin()));
    }
    [[nodiscard]] const std::vector<Powers>& terms() const { return terms_; }
    [[nodiscard]] const std::vector<Powers>& sums() const { return sums_; }

    /// `weight` and `height`: moment p at weight[p · stride].
    [[nodiscard]] double value(const double* weight, const double* height, Index stride, double x, double y) const {
        if (!(weight[0] > 0.0)) return std::numeric_limits<double>::quiet_NaN();
        const std::array<double, max_terms> coefficients = solve(weight, height, stride);
        double sum = 0.0;
        for (std::size_t a = 0; a < terms_.size(); ++a)
            sum += coefficients[a] * power(x, terms_[a].x) * power(y, terms_[a].y);
        return sum;
    }

private:
    static double power(double base, Index exponent) {
        return exponent == 0 ? 1.0 : exponent == 1 ? base : base * base;
    }

    /// Cholesky factorisation; a term that nearby points cannot distinguish from earlier ones is left out.
    std::array<double, max_terms> solve(const double* weight, const double* height, Index stride) const {
        const std::size_t count = terms_.size();
        std::array<std::array<double, max_terms>, max_terms> factor;
        std::array<double, max_terms> solution{};
        for (std::size_t a = 0; a < count; ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                double sum = weight[static_cast<Index>(products_[a * count + b]) * stride];
                for (std::size_t k = 0; k < b; ++k) sum -= factor[a][k] * factor[b][k];
                factor[a][b] = factor[b][b] > 0.0 ? sum / factor[b][b] : 0.0;
            }
            const double whole = weight[static_cast<Index>(products_[a * count + a]) * stride];
            double pivot = whole;
            for (std::size_t k = 0; k < a; ++k) pivot -= factor[a][k] * factor[a][k];
            factor[a][a] = pivot > smallest_pivot * whole ? std::sqrt(pivot) : 0.0;
            double sum = height[static_cast<Index>(a) * stride];
            for (std::size_t k = 0; k < a; ++k) sum -= factor[a][k] * solution[k];
            solution[a] = factor[a][a] > 0.0 ? sum / factor[a][a] : 0.0;
        }
        for (std::size_t a = count; a-- > 0;) {
            double sum = solution[a];
            for (std::size_t k = a + 1; k < count; ++k) sum -= factor[k][a] * solution[k];
            solution[a] = factor[a][a] > 0.0 ? sum / factor[a][a] : 0.0;
        }
        return solution;
    }

    std::vector<Powers> terms_, sums_;
    std::vector<std::size_t> products_;
};

struct Smoothing {
    const ArrayView2D& heights;
    const Array2D& weights;
    Census known;
    Index order;
    GaussianAxis along_x, along_y;
    LocalFit fit;
    bool separable, fits_x, fits_y;
    Array2D ones_x, ones_y;

    Smoothing(const ArrayView2D& map, const Array2D& factors, const Neighbourhood& near)
        : heights(map),
          weights(factors),
          known(census(map)),
          order(near.order),
          along_x(map.rows(), near.deviation[0], near.periodic, 2 * near.order),
          along_y(map.cols(), near.deviation[1], near.periodic, 2 * near.order),
          fit(near.order, near.deviation[0] > 0.0 ? near.order : 0, near.deviation[1] > 0.0 ? near.order : 0),
          separable(known.complete && factors.size() == 0),
          fits_x(near.order > 0 && near.deviation[0] > 0.0),
          fits_y(near.order > 0 && near.deviation[1] > 0.0) {
        if (!separable) return;
        ones_x = sums_of_one(along_x, 2 * order);
        ones_y = sums_of_one(along_y, 2 * order);
    }

    /// Moments of the heights, from which the fit is computed.
    MomentField height_moments(parallel::Threads threads) const {
        const auto load = [this](Index i, Index first, Index count, double* values) {
            const double* row = heights.data() + i * heights.outerStride() + first;
            if (separable) {
                for (Index j = 0; j < count; ++j) values[j] = row[j] - known.centre;
            } else if (weights.size() == 0) {
                for (Index j = 0; j < count; ++j) values[j] = std::isnan(row[j]) ? 0.0 : row[j] - known.centre;
            } else {
                const double* weight = &weights(i, first);
                for (Index j = 0; j < count; ++j)
                    values[j] = std::isnan(row[j]) ? 0.0 : weight[j] * (row[j] - known.centre);
            }
        };
        return {along_x, along_y, fit.terms(), load, threads};
    }

    MomentField weight_moments(parallel::Threads threads) const {
        const auto load = [this](Index i, Index first, Index count, double* values) {
            const double* row = heights.data() + i * heights.outerStride() + first;
            for (Index j = 0; j < count; ++j)
                values[j] = std::isnan(row[j]) ? 0.0 : weights.size() == 0 ? 1.0 : weights(i, first + j);
        };
        return {along_x, along_y, fit.sums(), load, threads};
    }
};

}  // namespace

namespace {

/// Means (order 0) and planes (order 1) of a complete map: weights are products, and uncorrelated along x and y.
void fit_planes(const Smoothing& smoothing, const MomentField& moments, Regression kind, Eigen::Ref<Array2D> result,
                parallel::Threads threads) {
    const Index nx = smoothing.along_x.points, ny = smoothing.along_y.points;
    const Levers along_x(smoothing.ones_x, smoothing.along_x.coordinate, smoothing.fits_x),
        along_y(smoothing.ones_y, smoothing.along_y.coordinate, smoothing.fits_y);
    const auto& terms = moments.powers();
    parallel::for_each_index(
        extent((ny + regression_columns_per_block - 1) / regression_columns_per_block), threads,
        [&](std::size_t block) {
            const Index first = static_cast<Index>(block) * regression_columns_per_block,
                        count = std::min(regression_columns_per_block, ny - first);
            Array1D sum(count), moment(count), value(count);
            for (Index i = 0; i < nx; ++i) {
                moments.moments(i, first, count, 0, sum.data());
                value = sum;
                for (std::size_t p = 1; p < terms.size(); ++p) {
                    moments.moments(i, first, count, p, moment.data());
                    if (terms[p].x == 1) value += along_x.lever[i] * (moment - along_x.mean[i] * sum);
                    else
                        value +=
                            along_y.lever.segment(first, count) * (moment - along_y.mean.segment(first, count) * sum);
                }
                value = smoothing.known.centre + value * (along_x.inverse[i] * along_y.inverse.segment(first, count));
                auto row = result.row(i).segment(first, count);
                if (kind == Regression::value) row = value.transpose();
                else row = smoothing.heights.row(i).segment(first, count) - value.transpose();
            }
        });
}

}  // namespace

void local_regression(const ArrayView2D& heights, const Array2D& weights, const Neighbourhood& neighbourhood,
                      Regression kind, Eigen::Ref<Array2D> result, parallel::Threads threads) {
    const Smoothing smoothing(heights, weights, neighbourhood);
    const MomentField of_heights = smoothing.height_moments(threads);
    if (smoothing.separable && smoothing.order < 2) {
        fit_planes(smoothing, of_heights, kind, result, threads);
        return;
    }
    std::vector<MomentField> of_weights;
    if (!smoothing.separable) of_weights.push_back(smoothing.weight_moments(threads));
    const Index nx = heights.rows(), ny = heights.cols();
    const std::size_t terms = smoothing.fit.terms().size(), sums = smoothing.fit.sums().size();
    parallel::for_each_index(
        extent((ny + regression_columns_per_block - 1) / regression_columns_per_block), threads,
        [&](std::size_t block) {
            const Index first = static_cast<Index>(block) * regression_columns_per_block,
                        count = std::min(regression_columns_per_block, ny - first);
            Array2D height(static_cast<Index>(terms), count), weight(static_cast<Index>(sums), count);
            for (Index i = 0; i < nx; ++i) {
                for (std::size_t p = 0; p < terms; ++p)
                    of_heights.moments(i, first, count, p, &height(static_cast<Index>(p), 0));
                for (std::size_t p = 0; p < sums; ++p) {
                    const Powers power = smoothing.fit.sums()[p];
                    if (!smoothing.separable)
                        of_weights[0].moments(i, first, count, p, &weight(static_cast<Index>(p), 0));
                    else
                        weight.row(static_cast<Index>(p)) =
                            smoothing.ones_x(power.x, i) * smoothing.ones_y.row(power.y).segment(first, count);
                }
                const double x = smoothing.along_x.coordinate[i];
                double* row = result.data() + i * result.outerStride() + first;
                const double* original = heights.data() + i * heights.outerStride() + first;
                if (smoothing.order == 0) height.row(0) /= weight.row(0);
                for (Index j = 0; j < count; ++j) {
                    const double value =
                        smoothing.known.centre + (smoothing.order == 0
                                                      ? height(0, j)
                                                      : smoothing.fit.value(&weight(0, j), &height(0, j), count, x,
                                                                            smoothing.along_y.coordinate[first + j]));
                    row[j] = kind == Regression::value ? value : original[j] - value;
                }
            }
        });
}

}  // namespace setae::processing
