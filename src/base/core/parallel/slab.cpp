// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/parallel/slab.hpp"

#include <algorithm>
#include <string>

#include "setae/core/errors.hpp"

namespace setae::parallel {

Slab::Slab(Index rows) : begins_{0, rows} {}

Slab::Slab(const Ranks* ranks, std::vector<Index> begins) : ranks_(ranks), begins_(std::move(begins)) {}

void Slab::share(double* all) const {
    if (ranks_ != nullptr) ranks_->share(all, begins_);
}

bool Slab::anywhere(bool here) const {
    if (in_one_process()) return here;
    std::vector<Index> begins;
    for (Index rank = 0; rank <= ranks(); ++rank) begins.push_back(rank);
    std::vector<double> flags(static_cast<std::size_t>(ranks()), 0.0);
    flags[static_cast<std::size_t>(own())] = here ? 1.0 : 0.0;
    ranks_->share(flags.data(), begins);
    return std::find(flags.begin(), flags.end(), 1.0) != flags.end();
}

void Slab::exchange(const void* send, std::span<const Index> send_begins, void* receive,
                    std::span<const Index> receive_begins) const {
    ranks_->exchange(send, send_begins, receive, receive_begins);
}

Index coarsest_side_of(Index n, Index coarsest) {
    while (n % 2 == 0 && n > coarsest) n /= 2;
    return n;
}

Slab nested_slab(Index rows, Index coarsest, Index step, const Ranks* ranks) {
    if (ranks == nullptr || ranks->count() == 1) return Slab(rows);
    const Index units = coarsest_side_of(rows, coarsest), steps = units / step, count = ranks->count();
    if (count > steps)
        throw InvalidArgument("a map of " + std::to_string(rows) + " rows for " + std::to_string(count) +
                              " processes; expected at most " + std::to_string(steps) + ", one per " +
                              std::to_string(step) + " rows of its coarsest grid");
    std::vector<Index> begins;
    for (Index r = 0; r < count; ++r) begins.push_back(steps * r / count * step * (rows / units));
    begins.push_back(rows);
    return {ranks, std::move(begins)};
}

}  // namespace setae::parallel
