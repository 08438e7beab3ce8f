// SPDX-License-Identifier: GPL-3.0-or-later
#include "patches.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::diagnostics {
namespace {

/// Selected points j = begin … end − 1 of one line along y.
struct Run {
    Index begin, end;
    std::int32_t number;
};

/// Sets of provisional numbers 1 …; the root of a set is its lowest number.
class Union {
public:
    [[nodiscard]] std::int32_t add() {
        parent_.push_back(static_cast<std::int32_t>(parent_.size()));
        return parent_.back();
    }
    [[nodiscard]] std::int32_t root(std::int32_t number) {
        auto& parent = parent_;
        while (parent[at(number)] != number) {
            parent[at(number)] = parent[at(parent[at(number)])];
            number = parent[at(number)];
        }
        return number;
    }
    void join(std::int32_t a, std::int32_t b) {
        a = root(a);
        b = root(b);
        if (a != b) parent_[at(std::max(a, b))] = std::min(a, b);
    }
    /// Numbers 1 … count of the sets in the order of their lowest members, by provisional number; 0 stays 0.
    [[nodiscard]] std::vector<std::int32_t> consecutive() {
        std::vector<std::int32_t> numbers(parent_.size(), 0);
        std::int32_t count = 0;
        for (std::size_t p = 1; p < parent_.size(); ++p) {
            const auto lowest = root(static_cast<std::int32_t>(p));
            numbers[p] = at(lowest) == p ? ++count : numbers[at(lowest)];
        }
        return numbers;
    }

private:
    static std::size_t at(std::int32_t number) { return static_cast<std::size_t>(number); }
    std::vector<std::int32_t> parent_{0};
};

/// Joins the runs of two neighbouring lines that touch; `reach` 1 also counts corners.
void join_lines(const std::vector<Run>& before, const std::vector<Run>& here, Index reach, Union& sets) {
    auto b = before.begin();
    for (const auto& run : here) {
        while (b != before.end() && b->end + reach <= run.begin) ++b;
        for (auto touching = b; touching != before.end() && touching->begin < run.end + reach; ++touching)
            sets.join(touching->number, run.number);
    }
}

/// Runs of a line of numbers.
std::vector<Run> runs_of(const PatchNumbers& numbers, Index line) {
    std::vector<Run> runs;
    const std::int32_t* row = numbers.row(line).data();
    for (Index j = 0; j < numbers.cols(); ++j) {
        if (row[j] == 0) continue;
        if (j == 0 || row[j - 1] == 0) runs.push_back({j, j, row[j]});
        runs.back().end = j + 1;
    }
    return runs;
}

void join_across_borders(const PatchNumbers& numbers, Index reach, Union& sets) {
    const Index nx = numbers.rows(), ny = numbers.cols();
    for (Index i = 0; i < nx; ++i)
        for (Index step = -reach; step <= reach; ++step) {
            const Index k = (i + step + nx) % nx;
            if (numbers(i, ny - 1) > 0 && numbers(k, 0) > 0) sets.join(numbers(i, ny - 1), numbers(k, 0));
        }
    join_lines(runs_of(numbers, nx - 1), runs_of(numbers, 0), reach, sets);
}

}  // namespace

Patches patches(const topography::Mask& mask, Neighbours neighbours, bool periodic) {
    if (mask.size() == 0)
        throw InvalidArgument(fmt::format("mask of {} x {} points; expected at least one", mask.rows(), mask.cols()));
    if (mask.size() >= std::numeric_limits<std::int32_t>::max())
        throw InvalidArgument(
            fmt::format("mask of {} x {} points; patches are numbered below 2^31 points", mask.rows(), mask.cols()));
    const Index nx = mask.rows(), ny = mask.cols(), reach = neighbours == Neighbours::edges_and_corners ? 1 : 0;
    Patches result{PatchNumbers(nx, ny)};
    Union sets;
    std::vector<Run> before, here;
    for (Index i = 0; i < nx; ++i) {
        const std::uint8_t* row = mask.row(i).data();
        std::int32_t* out = result.numbers.row(i).data();
        here.clear();
        for (Index j = 0; j < ny;) {
            const bool inside = row[j] != 0;
            const Index begin = j;
            while (j < ny && (row[j] != 0) == inside) ++j;
            if (inside) here.push_back({begin, j, 0});
            else std::fill(out + begin, out + j, 0);
        }
        // a run takes the number of one that it touches, so few numbers must be joined
        auto b = before.begin();
        for (auto& run : here) {
            while (b != before.end() && b->end + reach <= run.begin) ++b;
            run.number = b != before.end() && b->begin < run.end + reach ? b->number : sets.add();
            std::fill(out + run.begin, out + run.end, run.number);
        }
        join_lines(before, here, reach, sets);
        std::swap(before, here);
    }
    if (periodic) join_across_borders(result.numbers, reach, sets);
    const auto numbers = sets.consecutive();
    for (const auto number : numbers) result.count = std::max(result.count, number);
    std::int32_t* all = result.numbers.data();
    for (Index k = 0; k < result.numbers.size(); ++k) all[k] = numbers[static_cast<std::size_t>(all[k])];
    return result;
}

}  // namespace setae::diagnostics
