// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_search.hpp"

#include <algorithm>
#include <array>

namespace setae::topography {
namespace {

constexpr Index block = 8;
constexpr double infinite = std::numeric_limits<double>::infinity();

Index blocks_over(Index points) { return (points + block - 1) / block; }

/// max that keeps the first if the second is NaN; one instruction.
double larger(double kept, double candidate) { return candidate > kept ? candidate : kept; }

/// Highest over blocks of `block` points square.
Array2D coarsened(const Eigen::Map<const Array2D>& fine, parallel::Threads threads) {
    Array2D coarse = Array2D::Constant(blocks_over(fine.rows()), blocks_over(fine.cols()), -infinite);
    const Index whole = fine.cols() / block;
    parallel::for_each_index(static_cast<std::size_t>(coarse.rows()), threads, [&](std::size_t row) {
        const auto b = static_cast<Index>(row);
        double* out = &coarse(b, 0);
        for (Index i = b * block; i < std::min((b + 1) * block, fine.rows()); ++i) {
            const double* in = fine.data() + i * fine.cols();
            for (Index k = 0; k < whole; ++k) {
                double best = out[k];
                for (Index j = 0; j < block; ++j) best = larger(best, in[k * block + j]);
                out[k] = best;
            }
            for (Index j = whole * block; j < fine.cols(); ++j) out[whole] = larger(out[whole], in[j]);
        }
    });
    return coarse;
}

/// At every offset the lowest height at that or a farther offset of the same quadrant.
Array2D lowest_outward(Array2D bound, Index centre_x, Index centre_y) {
    for (Index i = 1; i < centre_x; ++i) bound.row(i) = bound.row(i).min(bound.row(i - 1));
    for (Index i = bound.rows() - 2; i > centre_x; --i) bound.row(i) = bound.row(i).min(bound.row(i + 1));
    if (centre_x > 0)
        bound.row(centre_x) = bound.row(centre_x).min(bound.row(centre_x - 1)).min(bound.row(centre_x + 1)).eval();
    for (Index j = 1; j < centre_y; ++j) bound.col(j) = bound.col(j).min(bound.col(j - 1));
    for (Index j = bound.cols() - 2; j > centre_y; --j) bound.col(j) = bound.col(j).min(bound.col(j + 1));
    if (centre_y > 0)
        bound.col(centre_y) = bound.col(centre_y).min(bound.col(centre_y - 1)).min(bound.col(centre_y + 1)).eval();
    return bound;
}

/// Offset from the apex to the nearest of the points first … last.
Index nearest_offset(Index first, Index last, Index apex) {
    return first > apex ? first - apex : last < apex ? last - apex : 0;
}

/// Stores the best candidate.
struct HighestFinder {
    Contact best;

    [[nodiscard]] bool can_hold(double bound) const { return bound > best.apex_height; }

    void row(const double* heights, const double* tip, Index points, Index x, Index y) {
        for (Index j = 0; j < points; ++j) {
            const double candidate = heights[j] - tip[j];
            if (candidate > best.apex_height) best = {candidate, x, y + j};
        }
    }

    /// A whole block: its highest candidate first, the place only if it is the best.
    void square(const double* heights, Index stride, const double* tip, Index tip_stride, Index x, Index y) {
        std::array<double, block> lanes;
        lanes.fill(-infinite);
        for (Index i = 0; i < block; ++i)
            for (Index j = 0; j < block; ++j)
                lanes[static_cast<std::size_t>(j)] =
                    larger(lanes[static_cast<std::size_t>(j)], heights[i * stride + j] - tip[i * tip_stride + j]);
        double highest = lanes[0];
        for (const double lane : lanes) highest = larger(highest, lane);
        if (!(highest > best.apex_height)) return;
        for (Index i = 0; i < block; ++i) row(heights + i * stride, tip + i * tip_stride, block, x + i, y);
    }
};

/// Counts points that reach a level, up to two.
struct TouchFinder {
    double level;
    ContactSearch::Touching found;

    [[nodiscard]] bool can_hold(double bound) const { return found.points < 2 && bound >= level; }

    void row(const double* heights, const double* tip, Index points, Index x, Index y) {
        for (Index j = 0; j < points && found.points < 2; ++j) {
            const double candidate = heights[j] - tip[j];
            if (!(candidate >= level)) continue;
            ++found.points;
            found.contact = {candidate, x, y + j};
        }
    }

    void square(const double* heights, Index stride, const double* tip, Index tip_stride, Index x, Index y) {
        for (Index i = 0; i < block; ++i) row(heights + i * stride, tip + i * tip_stride, block, x + i, y);
    }
};

/// Images n·k of a period whose window around the apex meets 0 … n − 1.
struct Images {
    Index first, last;
};

Images images(Index apex, Index reach, Index points, bool periodic) {
    if (!periodic) return {0, 0};
    const auto floor_division = [](Index a, Index b) { return a >= 0 ? a / b : -((-a + b - 1) / b); };
    return {floor_division(apex - reach, points), floor_division(apex + reach, points)};
}

}  // namespace

/// The apex in the coordinates of one image of the surface, and the considered points of the surface.
struct ContactSearch::Window {
    Index apex_x, apex_y;
    Index first_x, last_x, first_y, last_y;
};

ContactSearch::ContactSearch(const Array2D& heights, bool periodic_x, bool periodic_y, const TipImage& tip,
                             parallel::Threads threads)
    : heights_(heights.data(), heights.rows(), heights.cols()),
      periodic_x_(periodic_x),
      periodic_y_(periodic_y),
      reach_x_(tip.centre_x),
      reach_y_(tip.centre_y) {
    tip_ = Array2D::Constant(tip.heights.rows() + 2 * block, tip.heights.cols() + 2 * block, infinite);
    tip_.block(block, block, tip.heights.rows(), tip.heights.cols()) = tip.heights;
    bound_ = lowest_outward(tip.heights, reach_x_, reach_y_);
    // the coarsest level at which few blocks cover the reach
    constexpr Index few = 8;
    highest_.push_back(coarsened(heights_, threads));
    for (Index width = block; 2 * std::max(reach_x_, reach_y_) > (few - 2) * width; width *= block) {
        const auto& finest = highest_.back();
        if (finest.size() == 1) break;
        highest_.push_back(coarsened(Eigen::Map<const Array2D>(finest.data(), finest.rows(), finest.cols()), threads));
    }
}

double ContactSearch::tip_at(Index offset_x, Index offset_y) const {
    if (std::abs(offset_x) > reach_x_ || std::abs(offset_y) > reach_y_) return infinite;
    return tip_(offset_x + reach_x_ + block, offset_y + reach_y_ + block);
}

double ContactSearch::lowest_beyond(Index x, Index y) const {
    return std::abs(x) > reach_x_ || std::abs(y) > reach_y_ ? infinite : bound_(x + reach_x_, y + reach_y_);
}

template <class Finder>
void ContactSearch::visit_points(const Window& window, Finder& finder) const {
    const Index stride = heights_.cols(), tip_stride = tip_.cols();
    const double* heights = heights_.data() + window.first_x * stride + window.first_y;
    const double* tip =
        &tip_(window.first_x - window.apex_x + reach_x_ + block, window.first_y - window.apex_y + reach_y_ + block);
    if (window.last_x - window.first_x == block - 1 && window.last_y - window.first_y == block - 1) {
        finder.square(heights, stride, tip, tip_stride, window.first_x, window.first_y);
        return;
    }
    for (Index i = window.first_x; i <= window.last_x; ++i, heights += stride, tip += tip_stride)
        finder.row(heights, tip, window.last_y - window.first_y + 1, i, window.first_y);
}

template <class Finder>
void ContactSearch::descend(std::size_t level, const Window& window, Finder& finder) const {
    const Array2D& highest = highest_[level];
    Index width = block;
    for (std::size_t k = 0; k < level; ++k) width *= block;
    // blocks remain whole at the finest level: the margin of the tip covers points outside its reach
    for (Index bx = window.first_x / width; bx <= window.last_x / width; ++bx) {
        const Index first_x = bx * width, last_x = std::min(first_x + width, heights_.rows()) - 1;
        const double* bound = &bound_(nearest_offset(first_x, last_x, window.apex_x) + reach_x_, reach_y_);
        for (Index by = window.first_y / width; by <= window.last_y / width; ++by) {
            const Index first_y = by * width, last_y = std::min(first_y + width, heights_.cols()) - 1;
            if (!finder.can_hold(highest(bx, by) - bound[nearest_offset(first_y, last_y, window.apex_y)])) continue;
            if (level == 0) {
                visit_points({window.apex_x, window.apex_y, first_x, last_x, first_y, last_y}, finder);
            } else {
                descend(
                    level - 1,
                    {window.apex_x, window.apex_y, std::max(first_x, window.first_x), std::min(last_x, window.last_x),
                     std::max(first_y, window.first_y), std::min(last_y, window.last_y)},
                    finder);
            }
        }
    }
}

template <class Finder>
void ContactSearch::search(Index x, Index y, Finder& finder) const {
    const Index nx = heights_.rows(), ny = heights_.cols();
    const auto along_x = images(x, reach_x_, nx, periodic_x_), along_y = images(y, reach_y_, ny, periodic_y_);
    for (Index k = along_x.first; k <= along_x.last; ++k)
        for (Index l = along_y.first; l <= along_y.last; ++l) {
            const Index apex_x = x - k * nx, apex_y = y - l * ny;
            descend(highest_.size() - 1,
                    {apex_x, apex_y, std::max<Index>(apex_x - reach_x_, 0), std::min(apex_x + reach_x_, nx - 1),
                     std::max<Index>(apex_y - reach_y_, 0), std::min(apex_y + reach_y_, ny - 1)},
                    finder);
        }
}

Contact ContactSearch::highest(Index x, Index y, const Contact& guess) const {
    HighestFinder finder;
    const auto offer = [&](Index at_x, Index at_y) {
        const double candidate = heights_(at_x, at_y) - tip_at(at_x - x, at_y - y);
        if (candidate > finder.best.apex_height) finder.best = {candidate, at_x, at_y};
    };
    offer(x, y);
    if (guess.x >= 0) offer(guess.x, guess.y);
    search(x, y, finder);
    return finder.best;
}

ContactSearch::Touching ContactSearch::touching(Index x, Index y, double apex_height) const {
    TouchFinder finder{apex_height, {}};
    search(x, y, finder);
    return finder.found;
}

}  // namespace setae::topography
