// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/hysteresis/ranking.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::hysteresis {

struct TrialOptions {
    int runs = 20;           ///< of each law, > 0
    std::uint64_t seed = 1;  ///< of the first; the others have the next ones
    parallel::Threads threads;
    const std::atomic<bool>* cancelled = nullptr;
};

/// What became of a model that was planted.
struct LawTrials {
    RetractionModel planted;
    int runs = 0;
    int found = 0;           ///< it is Ranking::best()
    int possible = 0;        ///< it is not, but is not excluded
    int excluded = 0;        ///< another is clearly better, or a constant refuses it
    std::string most_taken;  ///< the other model that was best most often; empty where there was none
};

/// Both works of adhesion of pairs as a model would have them measured: inputs drawn within their ±, scatter of pairs,
/// surfaces and elastomers of both branches, own noise.
[[nodiscard]] std::vector<RankedPair> planted_pairs(const std::vector<RankedPair>& pairs, const ModelScore& score,
                                                    std::uint64_t seed);

/// Whether measurements like these could tell the models apart.
///
/// Every model of a ranking is planted on its pairs with its θ and its W_int, the scatter of the best one, and
/// everything else drawn with the ± it has; then all are ranked by what would have been measured. A model whose θ is 0
/// is another one, and left out. Same numbers for a seed and any number of threads.
/// @throws InvalidArgument for runs < 1; Cancelled where the options say so.
[[nodiscard]] std::vector<LawTrials> law_trials(const std::vector<RankedPair>& pairs, const Ranking& ranking,
                                                const std::optional<Estimate>& known_work, const TrialOptions& options);

}  // namespace setae::hysteresis

namespace setae::fields {

template <>
struct Described<hysteresis::LawTrials> {
    using T = hysteresis::LawTrials;
    static constexpr std::array rows{
        made<T>("planted", "retraction model of the simulated pairs", [](const T& of) { return of.planted.name(); }),
        inner<&T::planted>(),
        field<&T::runs>("runs", "number of data sets"),
        field<&T::found>("found", "number of data sets in which the true model was ranked best"),
        field<&T::possible>("possible",
                            "number of data sets in which another model was ranked best and the true model was not "
                            "excluded"),
        field<&T::excluded>(
            "excluded",
            "number of data sets in which the true model was excluded: another model was clearly better, "
            "or a constant error was found"),
        inner<&T::most_taken>(),
    };
    static constexpr Description description{"", "recovery of a known retraction model from simulated pairs", rows};
};
static_assert(complete<hysteresis::LawTrials>);

}  // namespace setae::fields
