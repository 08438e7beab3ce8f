// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_patches.hpp"

#include <algorithm>
#include <cmath>
#include "setae/core/extent.hpp"

namespace setae::processing {
namespace {

/// Whether any of some heights is undefined, by their sum: NaN propagates.
bool any_undefined(const double* heights, Index count) {
    double sums[4] = {0.0, 0.0, 0.0, 0.0};
    Index j = 0;
    for (; j + 4 <= count; j += 4)
        for (Index k = 0; k < 4; ++k) sums[k] += 0.0 * heights[j + k];
    for (; j < count; ++j) sums[0] += 0.0 * heights[j];
    return std::isnan((sums[0] + sums[1]) + (sums[2] + sums[3]));
}

class Joined {
public:
    std::size_t add() {
        parents_.push_back(parents_.size());
        return parents_.size() - 1;
    }
    std::size_t root(std::size_t a) {
        while (parents_[a] != a) a = parents_[a] = parents_[parents_[a]];
        return a;
    }
    void join(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        if (a != b) parents_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parents_;
};

bool overlap(const Run& a, const Run& b) { return a.first < b.first + b.count && b.first < a.first + a.count; }

/// Joins the runs of two neighbouring rows, both in order.
void join_rows(const std::vector<Run>& runs, std::size_t a, std::size_t a_end, std::size_t b, std::size_t b_end,
               Joined& joined) {
    while (a < a_end && b < b_end) {
        if (overlap(runs[a], runs[b])) joined.join(a, b);
        if (runs[a].first + runs[a].count < runs[b].first + runs[b].count) ++a;
        else ++b;
    }
}

}  // namespace

std::vector<Patch> undefined_patches(const ArrayView2D& heights, bool periodic) {
    constexpr Index columns_at_once = 64;
    const Index nx = heights.rows(), ny = heights.cols();
    std::vector<Run> runs;
    std::vector<std::size_t> row_begin(extent(nx) + 1, 0);
    Joined joined;
    for (Index i = 0; i < nx; ++i) {
        const double* row = heights.data() + i * heights.outerStride();
        for (Index block = 0; block < ny; block += columns_at_once) {
            const Index end = std::min(ny, block + columns_at_once);
            if (!any_undefined(row + block, end - block)) continue;
            for (Index j = block; j < end; ++j) {
                if (!std::isnan(row[j])) continue;
                const bool goes_on = runs.size() > row_begin[extent(i)] && runs.back().first + runs.back().count == j;
                if (goes_on) {
                    ++runs.back().count;
                } else {
                    runs.push_back({i, j, 1});
                    joined.add();
                }
            }
        }
        row_begin[extent(i) + 1] = runs.size();
        if (i > 0)
            join_rows(runs, row_begin[extent(i) - 1], row_begin[extent(i)], row_begin[extent(i)], runs.size(), joined);
        const std::size_t first = row_begin[extent(i)];
        if (periodic && runs.size() > first && runs[first].first == 0 && runs.back().first + runs.back().count == ny)
            joined.join(first, runs.size() - 1);
    }
    if (periodic && nx > 1) join_rows(runs, row_begin[0], row_begin[1], row_begin[extent(nx) - 1], runs.size(), joined);
    std::vector<Patch> patches;
    std::vector<std::size_t> number(runs.size());
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const std::size_t root = joined.root(r);
        if (root == r) {
            number[r] = patches.size();
            patches.emplace_back();
        }
        Patch& patch = patches[number[root]];
        patch.runs.push_back(runs[r]);
        patch.points += runs[r].count;
    }
    return patches;
}

}  // namespace setae::processing
