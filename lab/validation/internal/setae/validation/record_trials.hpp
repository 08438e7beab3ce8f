// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/fields/describe.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::validation {

/// One deviation of a record from an ideal one, such as "drift_30": drift of the force by 30 % of the pull-off.
struct RecordKind {
    std::string name;
    std::string group;    ///< group of the kind: kinds of one group are not combined
    std::string meaning;  ///< meaning for users
    /// Codes of warnings that name the cause where the record cannot be analysed as it is; a refusal whose message has
    /// the text after "refused:" counts like them.
    std::vector<std::string> causes{};
};

/// All kinds, in the order of the table. Percentages of forces are of the pull-off force 3/2 πRW_ret, those of
/// displacements of the largest penetration.
[[nodiscard]] const std::vector<RecordKind>& record_kinds();

/// Quantities of a record, and the routes to them.
inline constexpr std::array<std::string_view, 6> route_names{"E*",    "W", "W_ret", "W_pull_off", "W_last_points",
                                                             "E_loss"};

/// Result of one quantity by one route, and its true value.
struct RecordRoute {
    std::string name;  ///< one of route_names
    double known = 0.0;
    Estimate found;
};

/// One simulated record and its results.
struct RecordTrial {
    std::vector<std::string> kinds;  ///< one, or two combined
    std::uint64_t seed = 0;
    std::string refused;  ///< why the record was refused; empty: it was analysed
    std::vector<RecordRoute> routes{};
    std::vector<std::string> warnings{};  ///< codes
    bool cause_named = false;             ///< a warning or the refusal names the cause of one of the kinds
};

struct RecordTrialOptions {
    std::vector<std::string> kinds;  ///< names; empty: all
    bool pairs = false;              ///< all pairs of kinds of different groups, instead of each kind separately
    int runs = 20;                   ///< records of each kind, or of each pair
    std::uint64_t first_seed = 1;
    parallel::Threads threads;
    std::function<void(int)> progress;  ///< trials done; one call at a time
};

/// Simulated records of a sphere under fixed grips: R from 6 µm to 2 mm, E* 0.2 to 8 MPa, W 20 to 60 mJ/m², W_ret 1.05
/// to 2 times that, 200 to 600 samples from first contact to the largest force of four times the pull-off force, force
/// noise of 1 % of the pull-off force. Trials are equal for any number of threads.
/// @throws InvalidArgument for an unknown kind, with the names of all kinds.
[[nodiscard]] std::vector<RecordTrial> record_trials(const RecordTrialOptions& options);

/// Number of trials of record_trials().
[[nodiscard]] int number_of_trials(const RecordTrialOptions& options);

/// All trials of one route.
struct RouteSummary {
    std::string name;
    int count = 0;
    double bias = 0.0;  ///< median of found/known − 1; for a known 0, of the found value divided by W of retraction
    double bias_in_errors = 0.0;  ///< median of (found − known)/standard error
    double coverage = 0.0;        ///< share of 95 % intervals that cover the known value
};

/// All trials of one kind, or of one pair.
struct RecordSummary {
    std::string kinds;  ///< "drift_30", "drift_30 + hold"
    int count = 0;
    int refused = 0;
    int named = 0;  ///< refused or warned with the cause named
    /// Trials in which a route is off by more than four standard errors and 2 %, and nothing names a cause.
    int silent = 0;
    std::vector<RouteSummary> routes;
    std::map<std::string, int> warnings;  ///< number of records with each warning, by code
};

/// One summary per kind or pair, in the order of their first trial. together: all trials in one summary of that name.
[[nodiscard]] std::vector<RecordSummary> summary(const std::vector<RecordTrial>& trials);
[[nodiscard]] RecordSummary summary(const std::vector<RecordTrial>& trials, const std::string& together);

/// A table in Markdown, a row a summary, and the same as CSV.
[[nodiscard]] std::string record_table(const std::vector<RecordSummary>& rows);
[[nodiscard]] std::string record_csv(const std::vector<RecordTrial>& trials);

/// Output of `setae lab records`.
struct RecordsOutput {
    int runs = 0;
    std::uint64_t first_seed = 0;
    bool pairs = false;
    std::vector<RecordSummary> rows;
};

}  // namespace setae::validation

template <>
struct setae::fields::Described<setae::validation::RouteSummary> {
    using T = validation::RouteSummary;
    static constexpr std::array rows{
        field<&T::name>("quantity", "quantity and the route to it").one_of(validation::route_names),
        field<&T::count>("n", "number of records that give the quantity"),
        field<&T::bias>("bias",
                        "median of the found value divided by the true value, minus 1; for a true value of 0, divided "
                        "by the work of retraction"),
        field<&T::bias_in_errors>("bias_in_standard_errors", "median error in standard errors"),
        field<&T::coverage>("coverage", "share of 95 % intervals that cover the true value"),
    };
    static constexpr Description description{"", "all records of one quantity", rows};
};
static_assert(setae::fields::complete<setae::validation::RouteSummary>);

template <>
struct setae::fields::Described<setae::validation::RecordSummary> {
    using T = validation::RecordSummary;
    static constexpr std::array rows{
        field<&T::kinds>("kinds", "kind, or both kinds of a pair; `all` for all records"),
        field<&T::count>("records", "number of records"),
        field<&T::refused>("refused", "number of records that are not analysed"),
        field<&T::named>("cause_named", "number of records that are refused, or have a warning, with the fault named"),
        field<&T::silent>("silently_wrong",
                          "number of records with a quantity wrong by more than four standard errors and 2 %, without "
                          "the fault named"),
        field<&T::warnings>("warnings", "number of records with a warning, by code"),
        made<T>("routes", "one entry per quantity",
                [](const T& of) {
                    auto found = of.routes;
                    std::erase_if(found, [](const auto& route) { return route.count == 0; });
                    return found;
                }),
        inner<&T::routes>(),
    };
    static constexpr Description description{"", "all records of one kind, or of one pair of kinds", rows};
};
static_assert(setae::fields::complete<setae::validation::RecordSummary>);

template <>
struct setae::fields::Described<setae::validation::RecordsOutput> {
    using T = validation::RecordsOutput;
    static constexpr std::array rows{
        field<&T::runs>("runs", "number of records of each kind or pair"),
        field<&T::first_seed>("first_seed", "seed of the first record"),
        field<&T::pairs>("pairs", "whether all pairs of kinds are simulated"),
        field<&T::rows>("rows", "one entry per kind or pair, and one entry for all"),
    };
    static constexpr Description description{"", "simulated records with the faults of real experiments", rows};
};
static_assert(setae::fields::complete<setae::validation::RecordsOutput>);
