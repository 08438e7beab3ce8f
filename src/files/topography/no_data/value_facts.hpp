// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "height_bands.hpp"

namespace setae::topography {

/// Count, mean and scatter of numbers.
class Scatter {
public:
    void add(double number);
    void add(const Scatter& other);
    [[nodiscard]] Index count() const { return count_; }
    [[nodiscard]] double mean() const { return mean_; }
    [[nodiscard]] double standard_deviation() const;

private:
    Index count_ = 0;
    double mean_ = 0.0, squares_ = 0.0;
};

/// Distribution of the heights with an exact value among the others.
struct ValueFacts {
    Index count = 0;
    Index beyond = 0;  ///< others beyond the midpoint between the median and the value
    double nearest = std::numeric_limits<double>::infinity();  ///< distance of the nearest other height
    Scatter runs, gaps;  ///< lengths of its runs along scan lines, and of the gaps between two of them
    Index steps = 0;     ///< from a run to an adjacent defined height
    Index jumps = 0;     ///< those that are longer than `jump`
    Scatter adjacent;    ///< heights next to runs
};

struct AllFacts {
    std::vector<ValueFacts> values;  ///< in the order of the values
    Index defined = 0;               ///< heights, including those with the values
    double least, greatest;          ///< of the others
};

/// One pass over all heights. median: of the others. jump: a step larger than between neighbours.
[[nodiscard]] AllFacts facts_of(const HeightBands& bands, const std::vector<double>& values, double median,
                                double jump);

}  // namespace setae::topography
