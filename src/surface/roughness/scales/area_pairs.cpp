// SPDX-License-Identifier: GPL-3.0-or-later
#include "area_pairs.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "line_pairs.hpp"
#include "padded_rows.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"

namespace setae::scales {
namespace {

using fourier::block_count;
using fourier::Buffer;
using fourier::Complex;
using fourier::lines_per_block;

/// A map minus its mean, with sums of squares of its columns over the first rows.
class CentredMap {
public:
    CentredMap(const topography::HeightMap& map, parallel::Threads threads) : heights_(map.heights) {
        const Index nx = heights_.rows(), ny = heights_.cols(), blocks = block_count(nx);
        origin_ = undefined;
        for (Index i = 0; i < heights_.size() && std::isnan(origin_); ++i) origin_ = heights_.data()[i];
        if (std::isnan(origin_))
            throw UndefinedDataError(fmt::format("{}: no height is defined, so that there is no autocorrelation",
                                                 topography::label(map.metadata)));
        Array1D sums(blocks), counts(blocks);
        parallel::for_each_index(extent(blocks), threads, [&](std::size_t block) {
            double sum = 0.0, count = 0.0;
            each_row(static_cast<Index>(block), [&](Index i) {
                const auto row = heights_.row(i);
                const double quick = (row - origin_).sum();
                if (!std::isnan(quick)) {
                    sum += quick;
                    count += static_cast<double>(ny);
                } else {
                    sum += (!row.isNaN()).select(row - origin_, 0.0).sum();
                    count += static_cast<double>((!row.isNaN()).count());
                }
            });
            sums[static_cast<Index>(block)] = sum;
            counts[static_cast<Index>(block)] = count;
        });
        whole_ = counts.sum() == static_cast<double>(heights_.size());
        mean_ = sums.sum() / counts.sum();
        if (!std::isfinite(mean_))
            throw InvalidArgument(
                fmt::format("{}: a height is infinite; mark it as undefined", topography::label(map.metadata)));
    }

    [[nodiscard]] Index rows() const { return heights_.rows(); }
    [[nodiscard]] Index columns() const { return heights_.cols(); }
    [[nodiscard]] bool whole() const { return whole_; }
    [[nodiscard]] double centred(Index i, Index j) const { return (heights_(i, j) - origin_) - mean_; }
    void load(Index i, double* line) const {
        for (Index j = 0; j < columns(); ++j) line[j] = centred(i, j);
    }

    /// For each block of rows, sums over j-columns of the squares in all rows before it; the last row contains the
    /// totals.
    [[nodiscard]] Array2D squares_before_blocks(parallel::Threads threads) const {
        const Index blocks = block_count(rows());
        Array2D before = Array2D::Zero(blocks + 1, columns());
        parallel::for_each_index(extent(blocks), threads, [&](std::size_t block) {
            each_row(static_cast<Index>(block), [&](Index i) {
                before.row(static_cast<Index>(block) + 1) += ((heights_.row(i) - origin_) - mean_).square();
            });
        });
        for (Index b = 0; b < blocks; ++b) before.row(b + 1) += before.row(b);
        return before;
    }
    void add_squares(Index i, double sign, Eigen::Ref<Array1D> sums) const {
        sums += sign * ((heights_.row(i).transpose() - origin_) - mean_).square();
    }

private:
    template <class Body>
    void each_row(Index block, Body body) const {
        for (Index i = block * lines_per_block; i < std::min(heights_.rows(), (block + 1) * lines_per_block); ++i)
            body(i);
    }

    const Array2D& heights_;
    double origin_ = 0.0, mean_ = 0.0;
    bool whole_ = true;
};

/// Lengths of transforms and their plans.
struct Plan {
    Index nx, ny, padded_x, padded_y;
    fourier::RealTransform along_y;
    fourier::ComplexTransform along_x;
    fourier::RealTransform back_along_x;  ///< of a real spectrum; conjugate of the inverse
    fourier::InverseRealTransform back_along_y;

    Plan(const topography::HeightMap& map)
        : nx(map.heights.rows()),
          ny(map.heights.cols()),
          padded_x(map.periodic ? nx : fourier::fast_length(2 * nx - 1)),
          padded_y(map.periodic ? ny : fourier::fast_length(2 * ny - 1)),
          along_y(padded_y),
          along_x(padded_x),
          back_along_x(padded_x),
          back_along_y(padded_y) {}
    [[nodiscard]] Index modes() const { return along_y.modes(); }
    [[nodiscard]] double scale() const { return 1.0 / (static_cast<double>(padded_x) * static_cast<double>(padded_y)); }
};

/// The inverse along x of a real spectrum that is even in (x, y) together, lags 0 … `lags`.
void inverse_column(const Plan& plan, Buffer<double>& spectrum, Buffer<Complex>& modes, Index lags, Complex* column) {
    plan.back_along_x.forward(spectrum.data(), modes.data());
    for (Index k = 0; k <= lags; ++k) column[k] = std::conj(modes[extent(k)]);
}

/// Converts row spectra of heights to those of their correlation, by lag along x.
void correlate_columns(const Plan& plan, Index lags, RowSpectra& spectra, parallel::Threads threads) {
    const Index modes = plan.modes();
    parallel::for_each_index(extent(block_count(modes)), threads, [&](std::size_t block) {
        Columns columns(plan.padded_x);
        Buffer<double> power(extent(plan.padded_x));
        Buffer<Complex> lagged(extent(plan.back_along_x.modes()));
        const Index first = static_cast<Index>(block) * lines_per_block,
                    count = std::min(lines_per_block, modes - first);
        columns.take(spectra, plan.nx, modes, first, count);
        for (Index m = 0; m < count; ++m) {
            Complex* column = columns.column(m);
            plan.along_x.apply(column);
            for (Index p = 0; p < plan.padded_x; ++p) power[extent(p)] = std::norm(column[p]);
            inverse_column(plan, power, lagged, lags, column);
        }
        columns.put(spectra, lags + 1, modes, first, count);
    });
}

/// For row spectra of weights w, heights g and squares s: `squares` becomes that of ½ Σ w w (h − h)², `weights` that of
/// Σ w w.
void correlate_holed_columns(const Plan& plan, Index lags, RowSpectra& weights, RowSpectra& squares,
                             const RowSpectra& heights, parallel::Threads threads) {
    const Index modes = plan.modes();
    parallel::for_each_index(extent(block_count(modes)), threads, [&](std::size_t block) {
        Columns w(plan.padded_x), s(plan.padded_x), g(plan.padded_x);
        Buffer<double> pairs(extent(plan.padded_x)), differences(extent(plan.padded_x));
        Buffer<Complex> lagged(extent(plan.back_along_x.modes()));
        const Index first = static_cast<Index>(block) * lines_per_block,
                    count = std::min(lines_per_block, modes - first);
        w.take(weights, plan.nx, modes, first, count);
        s.take(squares, plan.nx, modes, first, count);
        g.take(heights, plan.nx, modes, first, count);
        for (Index m = 0; m < count; ++m) {
            for (auto* columns : {&w, &s, &g}) plan.along_x.apply(columns->column(m));
            for (Index p = 0; p < plan.padded_x; ++p) {
                differences[extent(p)] =
                    (std::conj(w.column(m)[p]) * s.column(m)[p]).real() - std::norm(g.column(m)[p]);
                pairs[extent(p)] = std::norm(w.column(m)[p]);
            }
            inverse_column(plan, differences, lagged, lags, s.column(m));
            inverse_column(plan, pairs, lagged, lags, w.column(m));
        }
        s.put(squares, lags + 1, modes, first, count);
        w.put(weights, lags + 1, modes, first, count);
    });
}

/// Row k of a correlation: out[l] for l = 0 … y, out[padded_y − l] for negative l.
void inverse_row(const Plan& plan, const RowSpectra& spectra, Index k, Buffer<Complex>& modes, Buffer<double>& out) {
    std::copy_n(spectra.data() + k * plan.modes(), plan.modes(), modes.data());
    plan.back_along_y.apply(modes.data(), out.data());
}

/// Sums of squares over the points of a map that are the first, and the second, of pairs k rows apart, by column.
struct PairSquares {
    Array1D first, second;              ///< by column j
    Array1D first_below, second_below;  ///< over columns < j, one entry more

    PairSquares(const CentredMap& map, const Array2D& before, Index k) : first(map.columns()), second(map.columns()) {
        first = up_to(map, before, map.rows() - k);
        second = before.row(before.rows() - 1).transpose() - up_to(map, before, k);
        sum_up();
    }
    void advance(const CentredMap& map, Index k) {
        map.add_squares(map.rows() - 1 - k, -1.0, first);
        map.add_squares(k, -1.0, second);
        sum_up();
    }
    /// ½ Σ (h² + h²) over pairs (k, l).
    [[nodiscard]] double half_sum(Index l) const {
        const Index ny = first.size();
        return l >= 0 ? 0.5 * (first_below[ny - l] + (second_below[ny] - second_below[l]))
                      : 0.5 * ((first_below[ny] - first_below[-l]) + second_below[ny + l]);
    }

private:
    static Array1D up_to(const CentredMap& map, const Array2D& before, Index rows) {
        Array1D sums = before.row(rows / lines_per_block).transpose();
        for (Index i = rows / lines_per_block * lines_per_block; i < rows; ++i) map.add_squares(i, 1.0, sums);
        return sums;
    }
    void sum_up() {
        first_below.setZero(first.size() + 1);
        second_below.setZero(first.size() + 1);
        for (Index j = 0; j < first.size(); ++j) {
            first_below[j + 1] = first_below[j] + first[j];
            second_below[j + 1] = second_below[j] + second[j];
        }
    }
};

void whole_rows(const Plan& plan, const CentredMap& map, bool periodic, Lags lags, parallel::Threads threads,
                const LagRow& consume) {
    RowSpectra spectra;
    transform_rows(
        plan.nx, plan.ny, plan.along_y, [&](Index i, double* line) { map.load(i, line); }, spectra, threads);
    correlate_columns(plan, lags.x, spectra, threads);
    const auto before = map.squares_before_blocks(threads);
    const double all = before.row(before.rows() - 1).sum();
    const auto points = static_cast<double>(plan.nx) * static_cast<double>(plan.ny);
    parallel::for_each_index(extent(block_count(lags.x + 1)), threads, [&](std::size_t block) {
        Buffer<Complex> modes(extent(plan.modes()));
        Buffer<double> correlation(extent(plan.padded_y)), values(extent(2 * lags.y + 1));
        const Index first = static_cast<Index>(block) * lines_per_block;
        std::optional<PairSquares> squares;
        if (!periodic) squares.emplace(map, before, first);
        for (Index k = first; k < std::min(lags.x + 1, first + lines_per_block); ++k) {
            inverse_row(plan, spectra, k, modes, correlation);
            const double scale = plan.scale();
            const auto rows_of_pairs = static_cast<double>(plan.nx - k);
            const auto value = [&](Index l, double product) {
                if (periodic) return std::max(0.0, (all - product * scale) / points);
                return std::max(0.0, (squares->half_sum(l) - product * scale) /
                                         (rows_of_pairs * static_cast<double>(plan.ny - std::abs(l))));
            };
            for (Index l = 0; l <= lags.y; ++l) values[extent(lags.y + l)] = value(l, correlation[extent(l)]);
            for (Index l = 1; l <= lags.y; ++l)
                values[extent(lags.y - l)] = value(-l, correlation[extent(plan.padded_y - l)]);
            consume(k, values.data());
            if (squares && k + 1 < plan.nx) squares->advance(map, k);
        }
    });
}

void holed_rows(const Plan& plan, const CentredMap& map, Lags lags, parallel::Threads threads, const LagRow& consume) {
    RowSpectra weights, squares;
    {
        const auto rows_of = [&](auto function, RowSpectra& spectra) {
            transform_rows(
                plan.nx, plan.ny, plan.along_y,
                [&](Index i, double* line) {
                    for (Index j = 0; j < plan.ny; ++j) {
                        const double h = map.centred(i, j);
                        line[j] = std::isnan(h) ? 0.0 : function(h);
                    }
                },
                spectra, threads);
        };
        RowSpectra heights;
        rows_of([](double) { return 1.0; }, weights);
        rows_of([](double h) { return h * h; }, squares);
        rows_of([](double h) { return h; }, heights);
        correlate_holed_columns(plan, lags.x, weights, squares, heights, threads);
    }
    parallel::for_each_index(extent(block_count(lags.x + 1)), threads, [&](std::size_t block) {
        Buffer<Complex> modes(extent(plan.modes()));
        Buffer<double> pairs(extent(plan.padded_y)), differences(extent(plan.padded_y)), values(extent(2 * lags.y + 1));
        const Index first = static_cast<Index>(block) * lines_per_block;
        for (Index k = first; k < std::min(lags.x + 1, first + lines_per_block); ++k) {
            inverse_row(plan, weights, k, modes, pairs);
            inverse_row(plan, squares, k, modes, differences);
            for (Index l = -lags.y; l <= lags.y; ++l) {
                const auto at = extent(l >= 0 ? l : plan.padded_y + l);
                const double count = std::round(pairs[at] * plan.scale());
                values[extent(lags.y + l)] =
                    count > 0.5 ? std::max(0.0, differences[at] * plan.scale() / count) : undefined;
            }
            consume(k, values.data());
        }
    });
}

}  // namespace

Lags lags_of(const topography::HeightMap& map) {
    const auto [nx, ny] = map.shape();
    return map.periodic ? Lags{nx / 2, ny / 2} : Lags{nx - 1, ny - 1};
}

void for_each_lag_row(const topography::HeightMap& map, parallel::Threads threads, const LagRow& consume) {
    const CentredMap centred(map, threads);
    const Plan plan(map);
    if (centred.whole()) whole_rows(plan, centred, map.periodic, lags_of(map), threads, consume);
    else holed_rows(plan, centred, lags_of(map), threads, consume);
}

}  // namespace setae::scales
