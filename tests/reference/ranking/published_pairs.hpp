// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "setae/adhesion/pair_point.hpp"
#include "setae/hysteresis/ranking.hpp"

namespace setae::reference {

/// The sixteen pairs of examples/nanodiamond/published.toml as the study ranks and fits them.
class PublishedPairs {
public:
    PublishedPairs();
    ~PublishedPairs();

    /// Both works of every pair.
    [[nodiscard]] const std::vector<hysteresis::RankedPair>& ranked() const { return ranked_; }
    /// W_app of every pair by the full-contact balance (Eq. 7).
    [[nodiscard]] const std::vector<adhesion::PairPoint>& points() const { return points_; }

private:
    struct Study;
    std::unique_ptr<Study> study_;  ///< holds the parameters that the pairs refer to
    std::vector<hysteresis::RankedPair> ranked_;
    std::vector<adhesion::PairPoint> points_;
};

}  // namespace setae::reference
