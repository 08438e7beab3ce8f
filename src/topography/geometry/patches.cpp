// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/geometry/patches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "checks.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::geometry {
namespace {

using topography::Mask;

/// Chosen points j = begin … end − 1 of one line along y.
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

/// Joins the runs of two neighbouring lines that touch; `reach` 1 counts corners too.
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

/// Sums over the points of one patch.
struct Sums {
    Index points = 0;
    double i = 0.0, j = 0.0;         ///< of indices, each unwrapped by whole periods
    Index edges_x = 0, edges_y = 0;  ///< towards points that are not chosen
};

/// Which pieces of a patch, cut at the borders of a periodic grid, lie how many periods apart.
class Pieces {
public:
    explicit Pieces(std::size_t count) : parent_(count), shift_(count, {0, 0}), endless_(count, false) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    struct Place {
        std::size_t root;
        std::array<Index, 2> shift;  ///< periods to add to a point of the piece to bring it beside the root's
    };
    [[nodiscard]] Place place(std::size_t piece) {
        std::size_t root = piece;
        std::array<Index, 2> total{0, 0};
        for (; parent_[root] != root; root = parent_[root])
            for (std::size_t d = 0; d < 2; ++d) total[d] += shift_[root][d];
        // the way is short ever after
        auto rest = total;
        while (parent_[piece] != root && piece != root) {
            const auto next = parent_[piece];
            const auto own = shift_[piece];
            parent_[piece] = root;
            shift_[piece] = rest;
            for (std::size_t d = 0; d < 2; ++d) rest[d] -= own[d];
            piece = next;
        }
        return {root, total};
    }
    /// b, moved by `step` periods, touches a.
    void join(std::size_t a, std::size_t b, std::array<Index, 2> step) {
        const auto at_a = place(a), at_b = place(b);
        // position of b's root seen from a's root
        std::array<Index, 2> offset{};
        for (std::size_t d = 0; d < 2; ++d) offset[d] = at_a.shift[d] + step[d] - at_b.shift[d];
        if (at_a.root == at_b.root) {
            if (offset[0] != 0 || offset[1] != 0) endless_[at_a.root] = true;
            return;
        }
        parent_[at_b.root] = at_a.root;
        shift_[at_b.root] = offset;
        endless_[at_a.root] = endless_[at_a.root] || endless_[at_b.root];
    }
    [[nodiscard]] bool endless(std::size_t root) const { return endless_[root]; }

private:
    std::vector<std::size_t> parent_;
    std::vector<std::array<Index, 2>> shift_;
    std::vector<bool> endless_;
};

/// Sums of every piece, number 0 for the points that are not chosen.
std::vector<Sums> sums_of(const PatchNumbers& numbers, std::int32_t count, bool periodic) {
    const Index nx = numbers.rows(), ny = numbers.cols();
    std::vector<Sums> sums(static_cast<std::size_t>(count) + 1);
    const auto of = [&](std::int32_t number) -> Sums& {
        if (number < 0 || number > count)
            throw InvalidArgument(fmt::format("patch number {} of {} patches", number, count));
        return sums[static_cast<std::size_t>(number)];
    };
    for (Index i = 0; i < nx; ++i) {
        const std::int32_t* row = numbers.row(i).data();
        const std::int32_t* next = numbers.row(i + 1 < nx ? i + 1 : 0).data();
        const bool has_next = i + 1 < nx || periodic;
        for (Index j = 0; j < ny; ++j) {
            const std::int32_t here = row[j], right = row[j + 1 < ny ? j + 1 : 0];
            if (here != 0) {
                auto& own = of(here);
                ++own.points;
                own.i += static_cast<double>(i);
                own.j += static_cast<double>(j);
            }
            if ((j + 1 < ny || periodic) && (here == 0) != (right == 0)) ++of(std::max(here, right)).edges_y;
            if (has_next && (here == 0) != (next[j] == 0)) ++of(std::max(here, next[j])).edges_x;
        }
    }
    return sums;
}

/// Pieces of a periodic grid with their places across its borders.
Pieces joined_pieces(const Patches& pieces) {
    const auto& numbers = pieces.numbers;
    const Index nx = numbers.rows(), ny = numbers.cols(),
                reach = pieces.neighbours == Neighbours::edges_and_corners ? 1 : 0;
    Pieces places(static_cast<std::size_t>(pieces.count) + 1);
    const auto join = [&](Index i, Index j, Index k, Index l) {
        // k, l may lie outside by one: the point there belongs to a grid one period away
        const std::array<Index, 2> step{k < 0 ? -1 : k >= nx ? 1 : 0, l < 0 ? -1 : l >= ny ? 1 : 0};
        const auto a = numbers(i, j), b = numbers(k - step[0] * nx, l - step[1] * ny);
        if (a > 0 && b > 0) places.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b), step);
    };
    for (Index i = 0; i < nx; ++i)
        for (Index d = -reach; d <= reach; ++d) join(i, ny - 1, i + d, ny);
    for (Index j = 0; j < ny; ++j)
        for (Index d = -reach; d <= reach; ++d) join(nx - 1, j, nx, j + d);
    return places;
}

double brought_into(double position, double size) {
    const double inside = position - size * std::floor(position / size);
    return inside < size ? inside : 0.0;
}

}  // namespace

Patches patches(const Mask& mask, Neighbours neighbours, bool periodic) {
    require_points(mask);
    if (mask.size() >= std::numeric_limits<std::int32_t>::max())
        throw InvalidArgument(
            fmt::format("mask of {} x {} points; patches are numbered below 2^31 points", mask.rows(), mask.cols()));
    const Index nx = mask.rows(), ny = mask.cols(), reach = neighbours == Neighbours::edges_and_corners ? 1 : 0;
    Patches result{PatchNumbers(nx, ny), 0, neighbours, periodic};
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
        // a run takes over the number of one it touches, so that few numbers have to be joined
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

std::vector<PatchShape> patch_shapes(const Patches& patches, std::array<double, 2> pixel_size) {
    require_pixels({pixel_size, patches.periodic});
    const auto& numbers = patches.numbers;
    const bool periodic = patches.periodic;
    const Patches pieces =
        periodic ? geometry::patches((numbers > 0).cast<std::uint8_t>(), patches.neighbours, false) : Patches{};
    const auto sums = periodic ? sums_of(pieces.numbers, pieces.count, true) : sums_of(numbers, patches.count, false);
    std::vector<Sums> total(static_cast<std::size_t>(patches.count));
    std::vector<PatchShape> shapes(total.size());
    if (periodic) {
        auto places = joined_pieces(pieces);
        std::vector<std::int32_t> patch_of(sums.size(), 0);
        for (Index k = 0; k < numbers.size(); ++k)
            patch_of[static_cast<std::size_t>(pieces.numbers.data()[k])] = numbers.data()[k];
        for (std::size_t p = 1; p < sums.size(); ++p) {
            const auto [root, shift] = places.place(p);
            const auto patch = static_cast<std::size_t>(patch_of[p] - 1);
            auto& sum = total[patch];
            const auto points = static_cast<double>(sums[p].points);
            sum.points += sums[p].points;
            sum.i += sums[p].i + points * static_cast<double>(shift[0] * numbers.rows());
            sum.j += sums[p].j + points * static_cast<double>(shift[1] * numbers.cols());
            sum.edges_x += sums[p].edges_x;
            sum.edges_y += sums[p].edges_y;
            if (places.endless(root)) shapes[patch].spans_period = true;
        }
    } else {
        std::copy(sums.begin() + 1, sums.end(), total.begin());
    }
    for (std::size_t p = 0; p < total.size(); ++p) {
        auto& shape = shapes[p];
        const auto& sum = total[p];
        const auto points = static_cast<double>(sum.points);
        shape.points = sum.points;
        shape.area = points * pixel_size[0] * pixel_size[1];
        shape.edge_length =
            static_cast<double>(sum.edges_x) * pixel_size[1] + static_cast<double>(sum.edges_y) * pixel_size[0];
        shape.centroid_x = sum.i / points * pixel_size[0];
        shape.centroid_y = sum.j / points * pixel_size[1];
        if (!periodic) continue;
        shape.centroid_x = shape.spans_period
                               ? undefined
                               : brought_into(shape.centroid_x, pixel_size[0] * static_cast<double>(numbers.rows()));
        shape.centroid_y = shape.spans_period
                               ? undefined
                               : brought_into(shape.centroid_y, pixel_size[1] * static_cast<double>(numbers.cols()));
    }
    return shapes;
}

}  // namespace setae::geometry
