// SPDX-License-Identifier: GPL-3.0-or-later
#include "moment_field.hpp"

#include <algorithm>
#include <array>
#include "setae/core/extent.hpp"

namespace setae::processing {
namespace {

constexpr Index moment_columns_per_block = 128;
constexpr std::size_t rows_at_once = 4;

constexpr std::array<std::array<double, 5>, 5> binomials{
    {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}}};

double binomial(Index n, Index k) { return binomials[extent(n)][extent(k)]; }

/// sum += a0 r0 + a1 r1 + a2 r2 + a3 r3, in this order for every column.
void add_four(double* __restrict sum, Index count, const std::array<const double*, rows_at_once>& rows,
              const std::array<double, rows_at_once>& weights) {
    const double *r0 = rows[0], *r1 = rows[1], *r2 = rows[2], *r3 = rows[3];
    const double a0 = weights[0], a1 = weights[1], a2 = weights[2], a3 = weights[3];
    for (Index j = 0; j < count; ++j) sum[j] += (a0 * r0[j] + a1 * r1[j]) + (a2 * r2[j] + a3 * r3[j]);
}

/// Collects weighted rows and adds them four at a time.
class RowSum {
public:
    RowSum(double* sum, Index count) : sum_(sum), count_(count) { std::fill(sum, sum + count, 0.0); }
    void add(const double* row, double weight) {
        rows_[held_] = row;
        weights_[held_] = weight;
        if (++held_ == rows_at_once) flush();
    }
    void finish() {
        if (held_ == 0) return;
        for (std::size_t rest = held_; rest < rows_at_once; ++rest) {
            rows_[rest] = rows_[0];
            weights_[rest] = 0.0;
        }
        flush();
    }

private:
    void flush() {
        add_four(sum_, count_, rows_, weights_);
        held_ = 0;
    }
    double* sum_;
    Index count_;
    std::size_t held_ = 0;
    std::array<const double*, rows_at_once> rows_{};
    std::array<double, rows_at_once> weights_{};
};

}  // namespace

std::vector<Powers> powers_up_to(Index total, Index max_x, Index max_y) {
    std::vector<Powers> powers;
    for (Index sum = 0; sum <= total; ++sum)
        for (Index y = std::max<Index>(0, sum - max_x); y <= std::min(sum, max_y); ++y) powers.push_back({sum - y, y});
    return powers;
}

MomentField::MomentField(const GaussianAxis& along_x, const GaussianAxis& along_y, std::vector<Powers> powers,
                         const LoadValues& load, parallel::Threads threads)
    : along_x_(&along_x), along_y_(&along_y), powers_(std::move(powers)) {
    for (const Powers& power : powers_) {
        max_x_ = std::max(max_x_, power.x);
        max_y_ = std::max(max_y_, power.y);
        total_ = std::max(total_, power.x + power.y);
    }
    if (!along_x.direct) share_rows(load, threads);
    gather_columns(load, threads);
}

void MomentField::share_rows(const LoadValues& load, parallel::Threads threads) {
    const GaussianAxis& axis = *along_x_;
    const Index ny = along_y_->points;
    for (Index m = 0; m <= max_x_; ++m) shared_.emplace_back(axis.coarse, ny);
    parallel::for_each_index(
        extent((ny + moment_columns_per_block - 1) / moment_columns_per_block), threads, [&](std::size_t block) {
            const Index first = static_cast<Index>(block) * moment_columns_per_block,
                        count = std::min(moment_columns_per_block, ny - first);
            for (Array2D& field : shared_) field.middleCols(first, count).setZero();
            std::vector<double> values(rows_at_once * extent(count), 0.0);
            const std::array<const double*, rows_at_once> sources{values.data(), values.data() + count,
                                                                  values.data() + 2 * count, values.data() + 3 * count};
            for (Index i = 0; i < axis.points; i += Index{rows_at_once}) {
                const Index rows = std::min(Index{rows_at_once}, axis.points - i);
                for (Index r = 0; r < rows; ++r) load(i + r, first, count, values.data() + r * count);
                const Index last = axis.first_share[extent(i + rows - 1)] + axis.shares;
                for (Index number = axis.first_share[extent(i)]; number < last; ++number) {
                    const Index c = axis.place(number);
                    if (c < 0) continue;
                    for (Index m = 0; m <= max_x_; ++m) {
                        std::array<double, rows_at_once> weights{};
                        for (Index r = 0; r < rows; ++r)
                            if (const Index s = number - axis.first_share[extent(i + r)]; s >= 0 && s < axis.shares)
                                weights[extent(r)] = axis.share[extent(m)](i + r, s);
                        add_four(&shared_[extent(m)](c, first), count, sources, weights);
                    }
                }
            }
        });
}

void MomentField::gather_columns(const LoadValues& load, parallel::Threads threads) {
    const GaussianAxis &axis = *along_y_, &rows_axis = *along_x_;
    const Index ny = axis.points, sources = rows_axis.direct ? 0 : max_x_;
    partial_.resize(extent(sources + 1));
    for (Index m = 0; m <= sources; ++m)
        for (Index l = 0; l <= std::min(max_y_, total_ - m); ++l)
            partial_[extent(m)].push_back(l == 0 && !rows_axis.direct ? std::move(shared_[extent(m)])
                                                                      : Array2D(rows_axis.coarse, ny));
    // coarse points beyond either end, so that outputs need no checks
    const Index margin = axis.taps;
    const auto reduce = [&](const double* row, Index n, Array1D& coarse) {
        coarse.setZero(axis.coarse + 2 * margin);
        if (axis.direct) {
            if (n == 0) std::copy(row, row + ny, coarse.data() + margin);
        } else {
            const Array2D& share = axis.share[extent(n)];
            for (Index j = 0; j < ny; ++j) {
                const Index first = axis.first_share[extent(j)];
                if (first >= 0 && first + axis.shares <= axis.coarse) {
                    double* target = coarse.data() + margin + first;
                    const double* weights = share.data() + j * axis.shares;
                    const double value = row[j];
                    for (Index s = 0; s < axis.shares; ++s) target[s] += weights[s] * value;
                } else {
                    for (Index s = 0; s < axis.shares; ++s)
                        if (const Index c = axis.place(first + s); c >= 0) coarse[margin + c] += share(j, s) * row[j];
                }
            }
        }
        if (axis.periodic)
            for (Index c = 0; c < margin; ++c) {
                coarse[c] = coarse[margin + axis.place(c - margin)];
                coarse[margin + axis.coarse + c] = coarse[margin + axis.place(axis.coarse + c)];
            }
    };
    parallel::for_each_index(extent(rows_axis.coarse), threads, [&](std::size_t number) {
        const Index c = static_cast<Index>(number);
        thread_local std::vector<double> row;
        thread_local std::vector<Array1D> coarse;
        row.resize(extent(ny));
        coarse.resize(5);
        for (Index m = 0; m <= sources; ++m) {
            if (rows_axis.direct) load(c, 0, ny, row.data());
            else std::copy_n(&partial_[extent(m)][0](c, 0), ny, row.data());
            const Index most = std::min(max_y_, total_ - m), held = axis.direct ? 0 : most;
            for (Index n = 0; n <= held; ++n) reduce(row.data(), n, coarse[extent(n)]);
            for (Index l = 0; l <= most; ++l) {
                double* target = &partial_[extent(m)][extent(l)](c, 0);
                for (Index j = 0; j < ny; ++j) {
                    double sum = 0.0;
                    for (Index n = 0; n <= std::min(l, held); ++n) {
                        const double* weights = axis.gather[extent(l - n)].data() + j * axis.taps;
                        const double* values = coarse[extent(n)].data() + margin + axis.first_tap[extent(j)];
                        double even = 0.0, odd = 0.0;
                        for (Index t = 0; t + 1 < axis.taps; t += 2) {
                            even += weights[t] * values[t];
                            odd += weights[t + 1] * values[t + 1];
                        }
                        if (axis.taps % 2 == 1) even += weights[axis.taps - 1] * values[axis.taps - 1];
                        sum += binomial(l, n) * (even + odd);
                    }
                    target[j] = sum;
                }
            }
        }
    });
}

void MomentField::moments(Index i, Index first, Index count, std::size_t p, double* values) const {
    const GaussianAxis& axis = *along_x_;
    const Powers power = powers_[p];
    RowSum sum(values, count);
    for (Index m = 0; m <= (axis.direct ? 0 : power.x); ++m) {
        const Array2D& partial = partial_[extent(m)][extent(power.y)];
        const Array2D& gather = axis.gather[extent(power.x - m)];
        for (Index t = 0; t < axis.taps; ++t)
            if (const Index c = axis.place(axis.first_tap[extent(i)] + t); c >= 0)
                sum.add(&partial(c, first), binomial(power.x, m) * gather(i, t));
    }
    sum.finish();
}

}  // namespace setae::processing
