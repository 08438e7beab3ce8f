// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Means over repeated measurements, as JSON has them.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/fields/describe.hpp"
#include "setae/statistics/mixed_model.hpp"
#include "setae/study/study_result.hpp"

namespace setae::output {

/// Labels of the groups of a row, by level.
using GroupLabels = std::vector<std::pair<std::string, std::string>>;

/// One row of the data.
struct ReplicateRow {
    const statistics::ReplicateData* data;
    std::size_t index = 0;

    [[nodiscard]] const statistics::Replicate& row() const { return data->rows[index]; }
    [[nodiscard]] GroupLabels groups() const {
        GroupLabels labels;
        for (std::size_t k = 0; k < data->levels.size(); ++k) labels.emplace_back(data->levels[k], row().groups[k]);
        return labels;
    }
    [[nodiscard]] std::optional<std::string> exclusion() const {
        const auto found = std::find_if(data->exclusions.begin(), data->exclusions.end(),
                                        [this](const auto& exclusion) { return exclusion.row == index; });
        if (found == data->exclusions.end()) return std::nullopt;
        return found->reason;
    }
};
[[nodiscard]] inline std::vector<ReplicateRow> rows_of(const statistics::ReplicateData& data) {
    std::vector<ReplicateRow> rows;
    for (std::size_t i = 0; i < data.rows.size(); ++i) rows.push_back({&data, i});
    return rows;
}

/// A quantity of the data.
[[nodiscard]] inline Quantity quantity_of(const statistics::ReplicateData& data, const Estimate& estimate) {
    return {.symbol = data.quantity, .estimate = estimate, .unit = data.unit};
}
/// A difference of values of the data.
[[nodiscard]] inline Quantity difference_of(const statistics::ReplicateData& data, const Estimate& estimate) {
    return {.symbol = "Δ" + data.quantity, .estimate = estimate, .unit = data.unit};
}

/// A variance component.
struct ComponentEntry {
    const statistics::ReplicateData* data;
    const statistics::VarianceComponent* component;

    /// The error of a root is that of its square over twice the root.
    [[nodiscard]] Quantity deviation() const {
        const double root = std::sqrt(component->variance);
        return {.estimate = {.value = root,
                             .standard_error = root > 0.0 ? 0.5 * component->standard_error / root : undefined,
                             .method = "delta"},
                .unit = data->unit};
    }
};

/// Variance components of some surfaces.
struct VariancesEntry {
    const statistics::ReplicateData* data;
    const statistics::VarianceFit* fit;
};

/// A prediction interval.
struct IntervalInUnit {
    Interval interval;
    std::string_view unit;
};

/// The mean without one group.
struct InfluenceEntry {
    const statistics::ReplicateData* data;
    const statistics::Influence* influence;
};

/// The mean of a surface.
struct SurfaceMeanEntry {
    const statistics::ReplicateData* data;
    const statistics::SurfaceMean* surface;

    [[nodiscard]] std::vector<std::pair<std::string, int>> groups() const {
        std::vector<std::pair<std::string, int>> numbers;
        for (std::size_t k = 1; k < data->levels.size(); ++k)
            numbers.emplace_back(data->levels[k], surface->groups[k - 1]);
        return numbers;
    }
    [[nodiscard]] std::vector<InfluenceEntry> influence() const {
        std::vector<InfluenceEntry> all;
        for (const auto& one : surface->influence) all.push_back({data, &one});
        return all;
    }
};

/// The difference of two surfaces.
struct DifferenceEntry {
    const statistics::ReplicateData* data;
    const statistics::SurfaceDifference* difference;
};

/// Means over replicates.
struct ReplicateMeans {
    const statistics::ReplicateData* data;
    const statistics::MixedModel* model;

    template <class Entry, class Part>
    [[nodiscard]] std::vector<Entry> entries(const std::vector<Part>& parts) const {
        std::vector<Entry> all;
        for (const auto& part : parts) all.push_back({data, &part});
        return all;
    }
};

/// Means over the loops on an elastomer, or why there are none.
struct ElastomerMeans {
    const study::ElastomerReplicates* replicates;
};

}  // namespace setae::output

namespace setae::fields {

template <>
struct Described<output::ReplicateRow> {
    using T = output::ReplicateRow;
    static constexpr std::array rows{
        made<T>("name", "file of the loop, or line of the table",
                [](const T& of) -> const std::string& { return of.row().name; }),
        made<T>("groups", "label of the group at each level", [](const T& of) { return of.groups(); })
            .with(Missing::left_out),
        made<T>("value", "measured value",
                [](const T& of) {
                    return output::quantity_of(
                        *of.data,
                        {.value = of.row().value, .standard_error = of.row().standard_error, .method = "fit"});
                }),
        made<T>("excluded", "the reason for the exclusion; null where the row counts",
                [](const T& of) { return of.exclusion(); })
            .or_null(),
    };
    static constexpr Description description{"", "one measurement", rows};
};

template <>
struct Described<output::ComponentEntry> {
    using T = output::ComponentEntry;
    static constexpr std::array rows{
        made<T>("level", "level of the groups; `repeat`: single rows",
                [](const T& of) -> const std::string& { return of.component->level; }),
        made<T>("includes", "levels with the same groups, which cannot be distinguished",
                [](const T& of) -> const auto& { return of.component->includes; }),
        made<T>("degrees_of_freedom", "number of groups minus number of groups of the level above",
                [](const T& of) { return of.component->degrees_of_freedom; }),
        made<T>("at_bound", "whether the restricted likelihood is largest at 0",
                [](const T& of) { return of.component->at_bound; }),
        made<T>("variance", "variance between the groups", [](const T& of) { return of.component->variance; }),
        made<T>("variance_standard_error", "standard error of the variance",
                [](const T& of) { return of.component->standard_error; }),
        made<T>("standard_deviation", "s", "", "root of the variance", [](const T& of) { return of.deviation(); }),
    };
    static constexpr Description description{"", "variance between the groups of a level", rows};
};

template <>
struct Described<output::VariancesEntry> {
    using T = output::VariancesEntry;
    static constexpr std::array rows{
        made<T>("surfaces", "surfaces that share these variances",
                [](const T& of) -> const auto& { return of.fit->surfaces; }),
        made<T>("components", "one entry per level, outermost first",
                [](const T& of) {
                    std::vector<output::ComponentEntry> all;
                    for (const auto& component : of.fit->components) all.push_back({of.data, &component});
                    return all;
                }),
        made<T>("not_estimable", "levels whose variance cannot be estimated, with the reason",
                [](const T& of) -> const auto& { return of.fit->not_estimable; }),
        made<T>("n", "number of rows", [](const T& of) { return of.fit->n; }),
        made<T>("converged", "whether the fit converged", [](const T& of) { return of.fit->converged; }),
        made<T>("log_likelihood", "restricted log-likelihood", [](const T& of) { return of.fit->log_likelihood; }),
        made<T>("within_fits", "s", "", "rms standard error of the rows, from their fits",
                [](const T& of) {
                    return Quantity{.estimate = {.value = std::sqrt(of.fit->known_variance)}, .unit = of.data->unit};
                })
            .as("standard_deviation_within_fits"),
    };
    static constexpr Description description{"", "variance components", rows};
};

template <>
struct Described<output::IntervalInUnit> {
    using T = output::IntervalInUnit;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) { return of.interval; }),
        inner<&T::interval>(),
        field<&T::unit>("unit", "unit of both ends"),
    };
    static constexpr Description description{"", "an interval with its unit", rows};
};
static_assert(complete<output::IntervalInUnit>);

template <>
struct Described<statistics::Heterogeneity> {
    using T = statistics::Heterogeneity;
    static constexpr std::array rows{
        field<&T::Q>("Q", "Cochran's Q: sum of squares over variances"),
        field<&T::degrees_of_freedom>("degrees_of_freedom", "degrees of freedom of Q"),
        field<&T::probability>("probability", "probability of a Q at least as large"),
        field<&T::I2>("I2", "share of the variance that the standard errors do not explain"),
    };
    static constexpr Description description{"", "scatter of the rows against their own standard errors", rows};
};
static_assert(complete<statistics::Heterogeneity>);

template <>
struct Described<output::InfluenceEntry> {
    using T = output::InfluenceEntry;
    static constexpr std::array rows{
        made<T>("level", "level of the group", [](const T& of) -> const std::string& { return of.influence->level; }),
        made<T>("group", "group that was left out",
                [](const T& of) -> const std::string& { return of.influence->group; }),
        made<T>("mean", "mean without the group; null where nothing remains",
                [](const T& of) -> std::optional<Quantity> {
                    if (!of.influence->mean) return std::nullopt;
                    return output::quantity_of(*of.data, *of.influence->mean);
                })
            .as("mean_without_it")
            .or_null(),
        made<T>("shift", "mean without the group minus mean of all",
                [](const T& of) { return output::difference_of(*of.data, {.value = of.influence->shift}); }),
    };
    static constexpr Description description{"", "mean of a surface without one group", rows};
};

template <>
struct Described<output::SurfaceMeanEntry> {
    using T = output::SurfaceMeanEntry;
    static constexpr std::string_view source =
        "linear mixed model, restricted likelihood, Satterthwaite's degrees of freedom; docs/guides/replicates.md";
    static constexpr std::array rows{
        made<T>("surface", "name of the surface",
                [](const T& of) -> const std::string& { return of.surface->surface; }),
        made<T>("mean", "mean of the surface",
                [](const T& of) {
                    auto mean = output::quantity_of(*of.data, of.surface->mean);
                    mean.n = of.surface->n;
                    return mean;
                })
            .from(source),
        made<T>("prediction_interval", "interval for one further measurement; null without an estimate of the scatter",
                [](const T& of) -> std::optional<output::IntervalInUnit> {
                    if (!of.surface->prediction) return std::nullopt;
                    return output::IntervalInUnit{*of.surface->prediction, of.data->unit};
                })
            .or_null(),
        made<T>("with_excluded", "mean with the excluded rows; null where none is excluded",
                [](const T& of) -> std::optional<Quantity> {
                    if (!of.surface->with_excluded) return std::nullopt;
                    return output::quantity_of(*of.data, *of.surface->with_excluded);
                })
            .as("mean_with_excluded")
            .or_null(),
        made<T>("heterogeneity",
                "test whether rows differ by more than their standard errors; null where they have none",
                [](const T& of) { return of.surface->heterogeneity; })
            .or_null(),
        made<T>("groups", "number of groups at each level below the surface", [](const T& of) { return of.groups(); })
            .with(Missing::left_out),
        made<T>("n", "number of rows of the mean", [](const T& of) { return of.surface->n; }),
        made<T>("excluded", "number of excluded rows", [](const T& of) { return of.surface->excluded; }),
        made<T>("influence", "mean without each outermost group", [](const T& of) { return of.influence(); }),
        made<T>("notes", "further notes on the mean", [](const T& of) -> const auto& { return of.surface->notes; }),
    };
    static constexpr Description description{"", "mean of a surface", rows};
};

template <>
struct Described<output::DifferenceEntry> {
    using T = output::DifferenceEntry;
    static constexpr std::array rows{
        made<T>("later", "the surface that is named later",
                [](const T& of) -> const std::string& { return of.difference->later; }),
        made<T>("earlier", "the surface that is named earlier",
                [](const T& of) -> const std::string& { return of.difference->earlier; }),
        made<T>("difference", "mean of the later surface minus mean of the earlier one",
                [](const T& of) { return output::difference_of(*of.data, of.difference->difference); }),
        made<T>("probability", "two-sided probability of a difference at least as large",
                [](const T& of) { return of.difference->probability; }),
    };
    static constexpr Description description{"", "difference of two surfaces", rows};
};

template <>
struct Described<output::ReplicateMeans> {
    using T = output::ReplicateMeans;
    static constexpr std::array rows{
        made<T>("quantity", "name of the quantity",
                [](const T& of) -> const std::string& { return of.data->quantity; }),
        made<T>("unit", "unit of the values", [](const T& of) -> const std::string& { return of.data->unit; }),
        made<T>("levels", "names of the levels, outermost first: the first is the surface",
                [](const T& of) -> const auto& { return of.data->levels; }),
        made<T>("pooling", "`surfaces`: all surfaces share their variances; `none`: each surface has its own",
                [](const T& of) {
                    return std::string_view(of.model->pooling == statistics::Pooling::surfaces ? "surfaces" : "none");
                }),
        made<T>("surfaces", "one entry per surface",
                [](const T& of) { return of.entries<output::SurfaceMeanEntry>(of.model->surfaces); }),
        made<T>("variances", "variance components: one entry where surfaces share them, else one per surface",
                [](const T& of) { return of.entries<output::VariancesEntry>(of.model->fits); }),
        made<T>("differences", "one entry per pair of surfaces",
                [](const T& of) { return of.entries<output::DifferenceEntry>(of.model->differences); }),
        made<T>("rows", "one entry per measurement", [](const T& of) { return output::rows_of(*of.data); }),
        made<T>("notes", "further notes", [](const T& of) -> const auto& { return of.model->notes; }),
    };
    static constexpr Description description{"replicates", "means over repeated measurements and their scatter", rows};
};

template <>
struct Described<output::ElastomerMeans> {
    using T = output::ElastomerMeans;
    static constexpr std::array rows{
        made<T>("elastomer", "name of the elastomer",
                [](const T& of) -> const std::string& { return of.replicates->elastomer; }),
        made<T>("quantity", "name of the quantity",
                [](const T& of) -> const std::string& { return of.replicates->data.quantity; }),
        made<T>("symbol", "symbol of the quantity",
                [](const T& of) -> const std::string& { return of.replicates->symbol; }),
        made<T>("reason", "the reason for missing means; the object then contains only `rows` of the means",
                [](const T& of) -> std::optional<std::string> {
                    if (of.replicates->model) return std::nullopt;
                    return of.replicates->model.reason;
                }),
        fields_of<T>([](const T& of) -> std::optional<output::ReplicateMeans> {
            if (!of.replicates->model) return std::nullopt;
            return output::ReplicateMeans{&of.replicates->data, &*of.replicates->model};
        }),
        made<T>("rows", "one entry per measurement", [](const T& of) { return output::rows_of(of.replicates->data); }),
    };
    static constexpr Description description{"elastomer_replicates", "means over the loops on an elastomer", rows};
};

}  // namespace setae::fields
