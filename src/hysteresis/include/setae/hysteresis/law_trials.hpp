// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "setae/hysteresis/ranking.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::hysteresis {

struct TrialOptions {
    int runs = 20;           ///< of each law, > 0
    std::uint64_t seed = 1;  ///< of the first; the others have the next ones
    parallel::Threads threads;
    const std::atomic<bool>* cancelled = nullptr;
};

/// What became of a law that was planted.
struct LawTrials {
    RetractionModel planted;
    int runs = 0;
    int found = 0;           ///< it is Ranking::best()
    int not_told_apart = 0;  ///< it is not, but is not told apart from the likeliest
    int refused = 0;         ///< it is told apart as wrong
    std::string most_taken;  ///< the other law that was best most often; empty where there was none
};

/// Whether measurements like these could tell the laws apart.
///
/// Every law of a ranking is planted on its pairs with its θ, the scatter of the best law, and everything else drawn
/// with the ± it has; then all laws are ranked by what would have been measured. A law whose θ is 0 is another one, and
/// left out. Same numbers for a seed and any number of threads.
/// @throws InvalidArgument for runs < 1; Cancelled where the options say so.
[[nodiscard]] std::vector<LawTrials> law_trials(const std::vector<ModelPoints>& models, const Ranking& ranking,
                                                const TrialOptions& options);

}  // namespace setae::hysteresis
