// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_sums.hpp"

#include <limits>

namespace setae::texture {
namespace {

double square(double x) { return x * x; }
double cube(double x) { return x * x * x; }

/// Sums at a height: a weight, and next to it a moment or volume if volumes are requested. Both are in one register, so
/// they are added simultaneously.
template <Volumes volumes>
struct Summand {
    using Values [[gnu::vector_size(2 * sizeof(double))]] = double;
    Values values{};

    void add(double weight, double volume) { values += Values{weight, volume}; }
    [[nodiscard]] double weight() const { return values[0]; }
    [[nodiscard]] double volume() const { return values[1]; }
};
template <>
struct Summand<Volumes::no> {
    double value = 0.0;

    void add(double weight, double) { value += weight; }
    [[nodiscard]] double weight() const { return value; }
    [[nodiscard]] static double volume() { return 0.0; }
};

/// The sums of one block; an element is "whole" for all heights up to its lowest corner, which is stored as one entry
/// at their number.
template <Volumes volumes>
class BlockSums {
public:
    explicit BlockSums(const HeightLocator& locate) : heights_(locate.heights()), origin_(heights_[0]) {
        const auto n = static_cast<std::size_t>(locate.count());
        whole_.resize(n + 1);
        part_.resize(n);
    }

    void operator()(const Triangle& t) {
        const double moment = ((t.a - origin_) + (t.b - origin_) + (t.c - origin_)) / 3.0;
        begin(t.a, t.c, t.below_a, 1.0, moment);
        if (t.below_a == t.below_c) return;
        if (t.below_a < t.below_b) {
            const double lower = 1.0 / ((t.b - t.a) * (t.c - t.a));
            for (int k = t.below_a; k < t.below_b; ++k) {
                const double above_a = heights_[k] - t.a;
                part(k).add(1.0 - square(above_a) * lower,
                            moment - (heights_[k] - origin_) + cube(above_a) * lower / 3.0);
            }
        }
        if (t.below_b < t.below_c) {
            const double upper = 1.0 / ((t.c - t.b) * (t.c - t.a));
            for (int k = t.below_b; k < t.below_c; ++k) {
                const double below_c = t.c - heights_[k];
                part(k).add(square(below_c) * upper, cube(below_c) * upper / 3.0);
            }
        }
    }

    void operator()(const Segment& s) {
        const double moment = s.weight * 0.5 * ((s.a - origin_) + (s.c - origin_));
        begin(s.a, s.c, s.below_a, s.weight, moment);
        for (int k = s.below_a; k < s.below_c; ++k) {
            const double share = (s.c - heights_[k]) / (s.c - s.a);
            part(k).add(s.weight * share, s.weight * 0.5 * share * (s.c - heights_[k]));
        }
    }

    void add_to(CurveSums& sums, Array1D& whole, Array1D& whole_moment) const {
        for (Index k = 0; k < whole.size(); ++k) {
            const auto& own = whole_[static_cast<std::size_t>(k)];
            whole[k] += own.weight();
            if constexpr (volumes == Volumes::yes) whole_moment[k] += own.volume();
        }
        for (Index k = 0; k < sums.above.size(); ++k) {
            const auto& own = part_[static_cast<std::size_t>(k)];
            sums.above[k] += own.weight();
            if constexpr (volumes == Volumes::yes) sums.volume[k] += own.volume();
        }
        sums.lowest = std::min(sums.lowest, lowest_);
        sums.highest = std::max(sums.highest, highest_);
    }

private:
    void begin(double a, double c, int below_a, double weight, double moment) {
        whole_[static_cast<std::size_t>(below_a)].add(weight, moment);
        // rarely true: no number waits for one stored just before
        if (a < lowest_) lowest_ = a;
        if (c > highest_) highest_ = c;
    }

    Summand<volumes>& part(int k) { return part_[static_cast<std::size_t>(k)]; }

    const double* heights_;
    double origin_;
    std::vector<Summand<volumes>> whole_, part_;
    double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -lowest_;
};

template <Volumes volumes>
CurveSums summed(const Elements& elements, const HeightLocator& locate, parallel::Threads threads) {
    std::vector<BlockSums<volumes>> blocks(elements.blocks(), BlockSums<volumes>(locate));
    parallel::for_each_index(elements.blocks(), threads, [&](std::size_t b) { elements.visit(b, locate, blocks[b]); });
    const auto n = static_cast<Index>(locate.count());
    CurveSums sums{Array1D::Zero(n),
                   Array1D::Zero(n),
                   volumes == Volumes::yes ? Array1D::Zero(n) : Array1D(),
                   0.0,
                   0.0,
                   std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
    Array1D whole = Array1D::Zero(n + 1), moment = whole;
    for (const auto& block : blocks) block.add_to(sums, whole, moment);
    for (Index k = n; k >= 0; --k) {
        sums.weight += whole[k];
        sums.moment += moment[k];
        if (k == 0) break;
        sums.whole[k - 1] = sums.weight;
        sums.above[k - 1] += sums.weight;
        if constexpr (volumes == Volumes::yes)
            sums.volume[k - 1] += sums.moment - sums.weight * (locate.heights()[k - 1] - locate.heights()[0]);
    }
    return sums;
}

}  // namespace

CurveSums sum_curve(const Elements& elements, const HeightLocator& locate, Volumes volumes, parallel::Threads threads) {
    auto sums = volumes == Volumes::yes ? summed<Volumes::yes>(elements, locate, threads)
                                        : summed<Volumes::no>(elements, locate, threads);
    elements.require_weight(sums.weight);
    return sums;
}

double share_above(const Triangle& t, double height) {
    if (height <= t.a) return 1.0;
    if (height <= t.b) return 1.0 - square(height - t.a) / ((t.b - t.a) * (t.c - t.a));
    return height <= t.c ? square(t.c - height) / ((t.c - t.b) * (t.c - t.a)) : 0.0;
}

double share_above(const Segment& s, double height) {
    if (height <= s.a) return 1.0;
    return height <= s.c ? (s.c - height) / (s.c - s.a) : 0.0;
}

namespace {

/// Contributions of one block to each interval.
class BlockBrackets {
public:
    BlockBrackets(std::span<const Index> intervals, const double* heights, const std::vector<std::size_t>& from)
        : intervals_(intervals), heights_(heights), from_(from), parts(intervals.size()) {}

    void operator()(const Triangle& t) {
        for (auto place = first(t.below_a); place < intervals_.size() && intervals_[place] <= t.below_c - 1; ++place) {
            const auto inside =
                static_cast<int>(intervals_[place]) + 1;  // corners with this many heights below are in the interval
            auto& part = parts[place];
            if (t.below_a == inside || t.below_b == inside || t.below_c == inside) {
                part.triangles.push_back(t);
            } else if (t.below_b > inside) {
                const double above_a = heights_[inside - 1] - t.a, curvature = 1.0 / ((t.b - t.a) * (t.c - t.a));
                add(part.parabola, 1.0 - square(above_a) * curvature, -2.0 * above_a * curvature, -curvature);
            } else {
                const double below_c = t.c - heights_[inside - 1], curvature = 1.0 / ((t.c - t.b) * (t.c - t.a));
                add(part.parabola, square(below_c) * curvature, -2.0 * below_c * curvature, curvature);
            }
        }
    }

    void operator()(const Segment& s) {
        for (auto place = first(s.below_a); place < intervals_.size() && intervals_[place] <= s.below_c - 1; ++place) {
            const auto inside = static_cast<int>(intervals_[place]) + 1;
            if (s.below_a == inside || s.below_c == inside) parts[place].segments.push_back(s);
            else
                add(parts[place].parabola, s.weight * (s.c - heights_[inside - 1]) / (s.c - s.a),
                    -s.weight / (s.c - s.a), 0.0);
        }
    }

private:
    static void add(Brackets::Parabola& p, double constant, double linear, double quadratic) {
        p.constant += constant;
        p.linear += linear;
        p.square += quadratic;
    }
    /// The first interval that does not end below the lowest corner of an element.
    [[nodiscard]] std::size_t first(int below_a) const {
        return from_[static_cast<std::size_t>(std::max(0, below_a - 1))];
    }

    std::span<const Index> intervals_;
    const double* heights_;
    const std::vector<std::size_t>& from_;

public:
    std::vector<Brackets::Interval> parts;
};

}  // namespace

Brackets::Brackets(const Elements& elements, const HeightLocator& locate, const CurveSums& sums,
                   std::span<const Index> intervals, parallel::Threads threads)
    : intervals_(intervals.size()), weight_(sums.weight) {
    std::vector<std::size_t> from(static_cast<std::size_t>(locate.count()) + 1, intervals.size());
    for (auto place = intervals.size(); place-- > 0;)
        for (Index j = intervals[place]; j >= 0 && from[static_cast<std::size_t>(j)] != place; --j)
            from[static_cast<std::size_t>(j)] = place;
    std::vector<BlockBrackets> blocks(elements.blocks(), BlockBrackets(intervals, locate.heights(), from));
    parallel::for_each_index(elements.blocks(), threads, [&](std::size_t b) { elements.visit(b, locate, blocks[b]); });
    for (std::size_t place = 0; place < intervals.size(); ++place) {
        auto& all = intervals_[place];
        all.start = locate.heights()[intervals[place]];
        all.parabola.constant = sums.whole[intervals[place] + 1];
        for (const auto& block : blocks) {
            const auto& part = block.parts[place];
            all.parabola.constant += part.parabola.constant;
            all.parabola.linear += part.parabola.linear;
            all.parabola.square += part.parabola.square;
            all.triangles.insert(all.triangles.end(), part.triangles.begin(), part.triangles.end());
            all.segments.insert(all.segments.end(), part.segments.begin(), part.segments.end());
        }
    }
}

double Brackets::ratio(std::size_t place, double height) const {
    const auto& at = intervals_[place];
    const double t = height - at.start;
    double above = at.parabola.constant + t * (at.parabola.linear + t * at.parabola.square);
    for (const auto& triangle : at.triangles) above += share_above(triangle, height);
    for (const auto& segment : at.segments) above += segment.weight * share_above(segment, height);
    return above / weight_;
}

}  // namespace setae::texture
