// SPDX-License-Identifier: GPL-3.0-or-later
#include "outliers.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::processing {
namespace {

constexpr std::array probabilities{0.5, 0.9, 0.99};
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The standard deviation of normal numbers whose absolute values have this quantile.
double deviation_of(double quantile, double probability) { return quantile / normal_quantile(0.5 + 0.5 * probability); }

/// Result of a pass over all numbers.
struct Pass {
    QuantileSearch magnitudes;
    Index zeros = 0;
    std::vector<Outlier> beyond = {};

    /// The first probability whose quantile is not 0.
    [[nodiscard]] std::optional<double> first_above_zero() const {
        for (const double probability : probabilities) {
            const double order = static_cast<double>(magnitudes.defined() - 1) * probability;
            if (static_cast<double>(zeros) <= std::ceil(order)) return probability;
        }
        return {};
    }
};

/// bound: numbers beyond it are kept; infinite: none.
Pass look_at_all(const ComputedRows& differences, const Bounds& bounds, double bound, parallel::Threads threads) {
    const Pass none{QuantileSearch(bounds)};
    const auto look = [&](Index first, Index last, Pass& pass) {
        Array1D row(differences.columns);
        for (Index i = first; i < last; ++i) {
            differences.load(i, row.data());
            for (Index j = 0; j < row.size(); ++j)
                if (std::fabs(row[j]) > bound) pass.beyond.push_back({i * row.size() + j, row[j]});
            row = row.abs();
            pass.zeros += (row == 0.0).count();
            pass.magnitudes.add(row.data(), row.size());
        }
    };
    Pass all = none;
    for (const auto& part :
         numerics::by_row_blocks(numerics::RowBlocks(differences.rows, differences.columns), threads, none, look)) {
        all.magnitudes.add(part.magnitudes);
        all.zeros += part.zeros;
        all.beyond.insert(all.beyond.end(), part.beyond.begin(), part.beyond.end());
    }
    return all;
}

/// Only numbers beyond a bound.
std::vector<Outlier> all_beyond(const ComputedRows& differences, double bound, parallel::Threads threads) {
    return look_at_all(differences, {infinity, infinity}, bound, threads).beyond;
}

/// The first probability whose quantile is not 0 by a sample.
double expected_above_zero(const Sample& sample) {
    for (const double probability : probabilities)
        if (sample.around(probability).high > 0.0) return probability;
    return probabilities.back();
}

}  // namespace

Outliers find_outliers(const ComputedRows& differences, double threshold, parallel::Threads threads) {
    const Sample sample(
        {differences.rows, differences.columns, {}, [&](Index i, Index j) { return std::fabs(differences.at(i, j)); }});
    double probability = expected_above_zero(sample);
    for (const double width : search_widths) {
        const auto bounds = sample.around(probability, width);
        const double least = bounds.low > 0.0 ? threshold * deviation_of(bounds.low, probability) : infinity;
        auto pass = look_at_all(differences, bounds, least, threads);
        if (pass.magnitudes.defined() == 0) return {};
        const auto first = pass.first_above_zero();
        if (!first) return {0.0, all_beyond(differences, 0.0, threads)};
        const auto quantile = *first == probability ? pass.magnitudes.quantile(probability) : std::nullopt;
        probability = *first;
        if (!quantile) continue;
        const double deviation = deviation_of(*quantile, probability), bound = threshold * deviation;
        if (least == infinity) return {deviation, all_beyond(differences, bound, threads)};
        std::erase_if(pass.beyond, [&](const Outlier& r) { return !(std::fabs(r.difference) > bound); });
        return {deviation, std::move(pass.beyond)};
    }
    throw InternalError("a quantile outside the values that were kept");
}

}  // namespace setae::processing
