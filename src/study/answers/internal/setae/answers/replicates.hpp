// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/fields/option.hpp"
#include "setae/output/replicate_fields.hpp"
#include "setae/statistics/mixed_model.hpp"
#include "setae/study/replicate_reader.hpp"

namespace setae::answers {

/// Request of `setae jkr summary`: tables with one row per fit, and the definition of replicates.
struct ReplicateRequest {
    std::vector<std::string> files;
    std::string quantity = "W", value, error, unit, method, branch, elastomer;
    std::string group_by, crossed;
    std::vector<std::string> exclude;
    std::string exclusions;
    bool each_surface = false;

    [[nodiscard]] study::ReplicateColumns columns() const;
};

/// Replicates and their statistics.
struct ReplicateSummary {
    study::ReplicateTables tables;
    statistics::MixedModel model;
};

/// @throws as study::read_replicates(), the readers of exclusions and statistics::mixed_model().
[[nodiscard]] ReplicateSummary replicate_summary(const ReplicateRequest& request);

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::study::BadRow> {
    using T = study::BadRow;
    static constexpr std::array rows{
        field<&T::place>("place", "file and line"),
        field<&T::reason>("reason", "the reason why the row was not read"),
    };
    static constexpr Description description{"", "a row that was not read", rows};
};
static_assert(setae::fields::complete<setae::study::BadRow>);

template <>
struct setae::fields::Described<setae::answers::ReplicateSummary> {
    using T = answers::ReplicateSummary;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) {
            return output::ReplicateMeans{&of.tables.data, &of.model};
        }),
        made<T>("bad_rows", "rows that were not read", [](const T& of) -> const auto& { return of.tables.bad_rows; }),
    };
    static constexpr Description description{"replicate_summary", "means over repeated measurements", rows};
};

template <>
struct setae::fields::Asked<setae::answers::ReplicateRequest> {
    using R = answers::ReplicateRequest;
    static constexpr std::array options{
        option<&R::quantity>("quantity", "quantity that is summarised: W, E*, E_loss, F_po, or the name of a column")
            .default_shown(),
        option<&R::group_by>("group_by", "columns of the groups, outermost first")
            .such_as("surface,lens")
            .or_else("surface, lens and spot, as far as the tables have them"),
        option<&R::crossed>("crossed",
                            "group columns whose labels name the same item on every surface, such as a lens pressed on "
                            "all surfaces"),
        option<&R::value>("value", "column of the values, where the name of the quantity does not determine it"),
        option<&R::error>("error",
                          "column of the standard errors, where the name of the quantity does not determine it"),
        option<&R::unit>("unit", "unit of values whose column states none").such_as("mJ/m2"),
        option<&R::method>("method", "fit method that is summarised, where tables have several")
            .or_else("the primary fit, where tables name it"),
        option<&R::branch>("branch", "branch that is summarised, where tables have several").such_as("loading"),
        option<&R::elastomer>("elastomer",
                              "elastomer that is summarised, where tables have several and no groups of elastomers"),
        option<&R::exclude>("exclude", "rows that are left out, as COLUMN=LABEL with a reason")
            .such_as("file=a.csv;reason=dust on the lens")
            .one_at_a_time(),
        option<&R::exclusions>("exclusions",
                               "file of exclusions: TOML with [[exclude]], or CSV with a column `reason`"),
        option<&R::each_surface>("each_surface", "separate variances for each surface, not pooled"),
    };
};
