// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/statistics/mixed_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

#include "jet.hpp"
#include "nested_design.hpp"
#include "restricted_likelihood.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::statistics {
namespace {

void check(const ReplicateData& data) {
    if (data.rows.empty()) throw InvalidArgument("no replicates; expected at least one row");
    if (data.levels.empty() || data.levels.size() + data.crossed.size() > Jet::most)
        throw InvalidArgument(
            fmt::format("{} levels of replicates, {} of them crossed; expected 1 to {} in all, the "
                        "surface first",
                        data.levels.size(), data.crossed.size(), Jet::most));
    for (const auto& level : data.crossed)
        if (std::find(data.levels.begin() + 1, data.levels.end(), level) == data.levels.end())
            throw InvalidArgument(fmt::format("'{}' cannot cross surfaces; expected one of the levels {}", level,
                                              fmt::join(data.levels.begin() + 1, data.levels.end(), ", ")));
    for (std::size_t i = 0; i < data.rows.size(); ++i) {
        const auto& row = data.rows[i];
        const auto where = row.name.empty() ? fmt::format("row {}", i) : fmt::format("row {} ({})", i, row.name);
        if (!std::isfinite(row.value))
            throw InvalidArgument(fmt::format("{}: value {}; expected a number", where, row.value));
        if (row.standard_error < 0.0 || std::isinf(row.standard_error))
            throw InvalidArgument(
                fmt::format("{}: standard error {}; expected a number >= 0, or none", where, row.standard_error));
        if (row.groups.size() != data.levels.size())
            throw InvalidArgument(fmt::format("{}: {} labels; expected {}, one for each of {}", where,
                                              row.groups.size(), data.levels.size(), fmt::join(data.levels, ", ")));
        for (std::size_t k = 0; k < data.levels.size(); ++k)
            if (row.groups[k].empty() && (k == 0 || !level_missing(data, k)))
                throw InvalidArgument(
                    fmt::format("{}: no {} is named, but other rows name one; name it or leave out the row", where,
                                data.levels[k]));
    }
    std::set<std::size_t> seen;
    for (const auto& exclusion : data.exclusions) {
        if (exclusion.row >= data.rows.size())
            throw InvalidArgument(
                fmt::format("row {} is excluded, but there are {}, counted from 0", exclusion.row, data.rows.size()));
        if (exclusion.reason.empty())
            throw InvalidArgument(fmt::format("row {} is excluded without a reason; give the reason", exclusion.row));
        if (!seen.insert(exclusion.row).second)
            throw InvalidArgument(fmt::format("row {} is excluded twice", exclusion.row));
    }
}

using Rows = std::vector<std::size_t>;

/// The rows for which a condition holds.
template <class Condition>
Rows rows_that(const ReplicateData& data, const Condition& condition) {
    Rows rows;
    for (std::size_t i = 0; i < data.rows.size(); ++i)
        if (condition(i)) rows.push_back(i);
    return rows;
}

/// A design with its maximum and further results.
struct Fitted {
    NestedDesign design;
    LikelihoodMaximum maximum;
    std::optional<DesignInformation> information;  ///< where a variance can be estimated

    /// Satterthwaite's ν of a variance with a gradient by θ, variances at 0 as cut there; at least 1.
    [[nodiscard]] double degrees_of_freedom(double variance, const Array1D& gradient) const {
        // a normal variable cut at its mean keeps 1/2 − 1/(2π) of its variance
        const double kept = std::sqrt(0.5 - 0.5 / pi);
        const Eigen::VectorXd slopes = (maximum.variances == 0.0).select(kept * gradient, gradient).matrix();
        const double error = slopes.dot(information->covariance.matrix() * slopes);
        return error > 0.0 ? std::max(1.0, 2.0 * variance * variance / error) : std::numeric_limits<double>::infinity();
    }

    [[nodiscard]] std::size_t place(const std::string& surface) const {
        return static_cast<std::size_t>(std::find(design.surfaces.begin(), design.surfaces.end(), surface) -
                                        design.surfaces.begin());
    }
};

Fitted fitted(const ReplicateData& data, const Rows& rows) {
    Fitted result{.design = nested_design(data, rows)};
    result.maximum = maximise_restricted_likelihood(result.design);
    if (!result.design.levels.empty() && result.maximum.variances.sum() + result.design.known_variance.sum() > 0.0)
        result.information = information_of(result.design, result.maximum.variances);
    return result;
}

Estimate with_freedom(Estimate estimate, double degrees_of_freedom, double level) {
    if (std::isfinite(degrees_of_freedom)) estimate.degrees_of_freedom = degrees_of_freedom;
    estimate.interval = interval_of(estimate, level);
    return estimate;
}

/// The mean of a surface; without a known variance between replicates, for one row its own, for several the weighted
/// one.
Estimate mean_of(const Fitted& fit, const std::string& surface, double level) {
    const auto place = fit.place(surface);
    if (fit.information) {
        const auto mean = fit.information->mean(place);
        return with_freedom({mean.value, std::sqrt(mean.variance), "mixed model"},
                            fit.degrees_of_freedom(mean.variance, mean.gradient), level);
    }
    // one row per surface, or all rows equivalent
    const auto at = std::find(fit.design.surface.begin(), fit.design.surface.end(), static_cast<int>(place)) -
                    fit.design.surface.begin();
    const double error = std::sqrt(fit.design.known_variance[at]);
    return with_freedom({fit.design.value[at], error > 0.0 ? error : undefined,
                         fit.design.levels.empty() ? "single measurement" : "mixed model"},
                        std::numeric_limits<double>::infinity(), level);
}

/// ∂mean/∂row of a surface, over all rows of the data.
Array1D weights_of(const Fitted& fit, const std::string& surface, std::size_t rows) {
    Array1D weights = Array1D::Zero(static_cast<Index>(rows));
    const auto place = static_cast<int>(fit.place(surface));
    const auto own = std::count(fit.design.surface.begin(), fit.design.surface.end(), place);
    for (std::size_t i = 0; i < fit.design.rows.size(); ++i)
        if (fit.information)
            weights[static_cast<Index>(fit.design.rows[i])] =
                fit.information->row_weights(place, static_cast<Index>(i));
        else if (fit.design.surface[i] == place)  // one row, or equal rows
            weights[static_cast<Index>(fit.design.rows[i])] = 1.0 / static_cast<double>(own);
    return weights;
}

std::optional<Interval> prediction_of(const Fitted& fit, const std::string& surface, double level) {
    if (!fit.information) return std::nullopt;
    const auto mean = fit.information->mean(fit.place(surface));
    const double variance = mean.variance + fit.maximum.variances.sum();
    const double reach =
        student_t_quantile(0.5 * (1.0 + level), fit.degrees_of_freedom(variance, mean.gradient + 1.0)) *
        std::sqrt(variance);
    return Interval{mean.value - reach, mean.value + reach, level};
}

std::optional<Heterogeneity> heterogeneity_of(const ReplicateData& data, const Rows& rows) {
    if (rows.size() < 2) return std::nullopt;
    double weights = 0.0, weighted = 0.0;
    for (const auto i : rows) {
        if (!(data.rows[i].standard_error > 0.0)) return std::nullopt;
        const double weight = std::pow(data.rows[i].standard_error, -2);
        weights += weight;
        weighted += weight * data.rows[i].value;
    }
    Heterogeneity result{.degrees_of_freedom = static_cast<int>(rows.size()) - 1};
    for (const auto i : rows)
        result.Q += std::pow((data.rows[i].value - weighted / weights) / data.rows[i].standard_error, 2);
    result.probability = chi_squared_exceedance(result.Q, result.degrees_of_freedom);
    if (result.Q > result.degrees_of_freedom) result.I2 = 1.0 - result.degrees_of_freedom / result.Q;
    return result;
}

VarianceFit variance_fit(const ReplicateData& data, const Fitted& fit) {
    VarianceFit result{.surfaces = fit.design.surfaces,
                       .not_estimable = fit.design.not_estimable,
                       .log_likelihood = fit.maximum.log_likelihood,
                       .n = static_cast<int>(fit.design.size()),
                       .converged = fit.maximum.converged};
    for (std::size_t k = 0; k < fit.design.levels.size(); ++k) {
        const auto& level = fit.design.levels[k];
        const auto place = static_cast<Index>(k);
        const double variance = fit.maximum.variances[place];
        result.components.push_back({level.includes.front(), level.includes, variance,
                                     fit.information ? std::sqrt(fit.information->covariance(place, place)) : undefined,
                                     level.degrees_of_freedom, variance == 0.0});
    }
    double sum = 0.0, known = 0.0;
    for (const auto row : fit.design.rows)
        if (std::isfinite(data.rows[row].standard_error)) {
            sum += std::pow(data.rows[row].standard_error, 2);
            known += 1.0;
        }
    if (known > 0.0) result.known_variance = sum / known;
    return result;
}

/// Estimation of means from rows: the part of the model that is repeated with other rows.
class Fits {
public:
    Fits(const ReplicateData& data, const Rows& rows, Pooling pooling) {
        std::vector<std::string> surfaces;
        for (const auto i : rows)
            if (const auto& name = data.rows[i].groups[0];
                std::find(surfaces.begin(), surfaces.end(), name) == surfaces.end())
                surfaces.push_back(name);
        if (pooling == Pooling::surfaces) {
            fits_.push_back(fitted(data, rows));
            return;
        }
        for (const auto& surface : surfaces) {
            Rows own;
            for (const auto i : rows)
                if (data.rows[i].groups[0] == surface) own.push_back(i);
            fits_.push_back(fitted(data, own));
        }
    }

    [[nodiscard]] const std::vector<Fitted>& all() const { return fits_; }
    /// nullptr where no row is on the surface.
    [[nodiscard]] const Fitted* of(const std::string& surface) const {
        for (const auto& fit : fits_)
            if (fit.place(surface) < fit.design.surfaces.size()) return &fit;
        return nullptr;
    }

private:
    std::vector<Fitted> fits_;
};

/// The outermost level at which a surface has at least two groups, and their labels; the rows' names where it has none.
struct OuterGroups {
    std::size_t level = 0;  ///< the number of levels: each row
    std::vector<std::string> labels;
};

OuterGroups outer_groups(const ReplicateData& data, const Rows& rows) {
    for (std::size_t level = 1; level < data.levels.size(); ++level) {
        OuterGroups found{.level = level};
        for (const auto i : rows)
            if (const auto& label = data.rows[i].groups[level];
                std::find(found.labels.begin(), found.labels.end(), label) == found.labels.end())
                found.labels.push_back(label);
        if (found.labels.size() > 1) return found;
    }
    return {.level = data.levels.size()};
}

std::vector<Influence> influence_of(const ReplicateData& data, const Rows& used, const Rows& own, const Estimate& mean,
                                    const MixedModelOptions& options) {
    std::vector<Influence> result;
    const auto outer = outer_groups(data, own);
    const auto& surface = data.rows[own.front()].groups[0];
    const auto add = [&](std::string level, std::string label, const auto& left_out) {
        Rows rest;
        for (const auto i : used)
            if (!left_out(i)) rest.push_back(i);
        Influence influence{.level = std::move(level), .group = std::move(label)};
        const Fits fits(data, rest, options.pooling);
        if (const auto* fit = fits.of(surface)) {
            influence.mean = mean_of(*fit, surface, options.level);
            influence.shift = influence.mean->value - mean.value;
        }
        result.push_back(std::move(influence));
    };
    if (outer.level < data.levels.size())
        for (const auto& label : outer.labels)
            add(data.levels[outer.level], label, [&](std::size_t i) {
                return data.rows[i].groups[0] == surface && data.rows[i].groups[outer.level] == label;
            });
    else if (own.size() > 1)
        for (const auto row : own)
            add("repeat", data.rows[row].name.empty() ? fmt::format("row {}", row) : data.rows[row].name,
                [&](std::size_t i) { return i == row; });
    return result;
}

/// Groups of each level below the surface.
std::vector<int> group_counts(const ReplicateData& data, const Rows& rows) {
    std::vector<int> counts;
    for (std::size_t level = 1; level < data.levels.size(); ++level) {
        std::set<std::vector<std::string>> groups;
        for (const auto i : rows)
            groups.insert(
                {data.rows[i].groups.begin(), data.rows[i].groups.begin() + static_cast<std::ptrdiff_t>(level) + 1});
        counts.push_back(level_missing(data, level) ? 0 : static_cast<int>(groups.size()));
    }
    return counts;
}

std::vector<std::string> notes_of(const ReplicateData& data, const Fitted& fit, const Rows& own) {
    std::vector<std::string> notes;
    const auto without =
        std::count_if(own.begin(), own.end(), [&](std::size_t i) { return std::isnan(data.rows[i].standard_error); });
    if (own.size() == 1)
        notes.push_back(
            fit.information
                ? "one measurement: replicates are missing, and the variances are those of the other surfaces"
            : without == 0
                ? "one measurement: replicates are missing, and the error is only that of its own fit"
                : "one measurement without a standard error: replicates are missing, and nothing is known about "
                  "the error");
    else if (!fit.information)
        notes.emplace_back("all values are equal and have no standard error, so that the error of the mean is unknown");
    else if (without > 0)
        notes.push_back(
            fmt::format("{} of {} rows have no standard error: the errors of their fits are part of the variance of "
                        "repeats",
                        without, own.size()));
    return notes;
}

SurfaceDifference difference_of(const Fits& fits, const SurfaceMean& later, const SurfaceMean& earlier, double level) {
    SurfaceDifference result{.later = later.surface, .earlier = earlier.surface};
    const auto* fit = fits.of(later.surface);
    if (fit == fits.of(earlier.surface) && fit->information) {
        const auto found = fit->information->difference(fit->place(later.surface), fit->place(earlier.surface));
        result.difference = with_freedom({found.value, std::sqrt(found.variance), "mixed model"},
                                         fit->degrees_of_freedom(found.variance, found.gradient), level);
    } else {
        auto plain = [](Estimate estimate) {
            estimate.interval.reset();
            return estimate;
        };
        result.difference = difference(plain(later.mean), plain(earlier.mean));
        result.difference.interval = interval_of(result.difference, level);
    }
    if (result.difference.uncertain()) {
        const double t = std::abs(result.difference.value) / result.difference.standard_error;
        result.probability =
            2.0 * student_t_probability(
                      -t, result.difference.degrees_of_freedom.value_or(std::numeric_limits<double>::infinity()));
    }
    return result;
}

/// A label of the outermost groups, where these hold others, that more than one surface has.
std::optional<std::string> label_on_two_surfaces(const ReplicateData& data, const Rows& rows) {
    if (data.levels.size() < 3) return std::nullopt;
    std::map<std::string, std::string> surface_of;
    for (const auto i : rows) {
        const auto& groups = data.rows[i].groups;
        if (!groups[1].empty() && surface_of.try_emplace(groups[1], groups[0]).first->second != groups[0])
            return groups[1];
    }
    return std::nullopt;
}

}  // namespace

MixedModel mixed_model(const ReplicateData& data, const MixedModelOptions& options) {
    check(data);
    std::set<std::size_t> excluded;
    for (const auto& exclusion : data.exclusions) excluded.insert(exclusion.row);
    const auto used = rows_that(data, [&](std::size_t i) { return !excluded.contains(i); });
    if (used.empty())
        throw UndefinedDataError(fmt::format("all {} rows are excluded; a mean needs at least one", data.rows.size()));
    const Fits fits(data, used, options.pooling);
    std::optional<Fits> with_excluded;
    if (!excluded.empty())
        with_excluded.emplace(data, rows_that(data, [](std::size_t) { return true; }), options.pooling);

    MixedModel model{.levels = data.levels, .crossed = data.crossed, .pooling = options.pooling};
    for (const auto& fit : fits.all()) model.fits.push_back(variance_fit(data, fit));
    std::vector<std::string> names;
    for (const auto& row : data.rows)
        if (std::find(names.begin(), names.end(), row.groups[0]) == names.end()) names.push_back(row.groups[0]);
    for (const auto& name : names) {
        const auto on_it = rows_that(data, [&](std::size_t i) { return data.rows[i].groups[0] == name; });
        Rows own;
        for (const auto i : on_it)
            if (!excluded.contains(i)) own.push_back(i);
        if (own.empty()) {
            model.notes.push_back(fmt::format("{}: every measurement is excluded", name));
            continue;
        }
        const auto* fit = fits.of(name);
        SurfaceMean surface{.surface = name,
                            .mean = mean_of(*fit, name, options.level),
                            .prediction = prediction_of(*fit, name, options.level),
                            .heterogeneity = heterogeneity_of(data, own),
                            .groups = group_counts(data, own),
                            .n = static_cast<int>(own.size()),
                            .excluded = static_cast<int>(on_it.size() - own.size()),
                            .weights = weights_of(*fit, name, data.rows.size()),
                            .notes = notes_of(data, *fit, own)};
        if (surface.excluded > 0) surface.with_excluded = mean_of(*with_excluded->of(name), name, options.level);
        if (options.influence && own.size() > 1)
            surface.influence = influence_of(data, used, own, surface.mean, options);
        model.surfaces.push_back(std::move(surface));
    }
    if (const auto shared = label_on_two_surfaces(data, used); shared && data.crossed.empty())
        model.notes.push_back(
            fmt::format("{0} {1} is on several surfaces and treated as a different one on each; if it is the same, set "
                        "{0} as crossed",
                        data.levels[1], *shared));
    for (std::size_t later = 1; later < model.surfaces.size(); ++later)
        for (std::size_t earlier = 0; earlier < later; ++earlier)
            model.differences.push_back(
                difference_of(fits, model.surfaces[later], model.surfaces[earlier], options.level));
    return model;
}

}  // namespace setae::statistics
