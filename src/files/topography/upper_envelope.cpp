// SPDX-License-Identifier: GPL-3.0-or-later
#include "upper_envelope.hpp"

#include <algorithm>
#include <limits>

namespace setae::topography {
namespace {

using Pieces = std::vector<VisiblePiece>;

void append(Pieces& pieces, VisiblePiece piece) {
    if (!(piece.begin < piece.end)) return;
    if (!pieces.empty() && pieces.back().segment == piece.segment && pieces.back().end == piece.begin)
        pieces.back().end = piece.end;
    else pieces.push_back(piece);
}

/// The higher of two envelopes of a curve.
class Merge {
public:
    Merge(const Array1D& x, const Array1D& y) : x_(x), y_(y) {}

    [[nodiscard]] Pieces operator()(const Pieces& a, const Pieces& b) const {
        constexpr double nowhere = std::numeric_limits<double>::infinity();
        Pieces result;
        result.reserve(a.size() + b.size());
        std::size_t i = 0, j = 0;
        double position = -nowhere;
        while (i < a.size() || j < b.size()) {
            const double a_begin = i < a.size() ? std::max(a[i].begin, position) : nowhere;
            const double b_begin = j < b.size() ? std::max(b[j].begin, position) : nowhere;
            const double begin = std::min(a_begin, b_begin);
            double end;
            if (a_begin == b_begin) {
                end = std::min(a[i].end, b[j].end);
                higher(result, a[i].segment, b[j].segment, begin, end);
            } else if (a_begin < b_begin) {
                end = std::min(a[i].end, b_begin);
                append(result, {a[i].segment, begin, end});
            } else {
                end = std::min(b[j].end, a_begin);
                append(result, {b[j].segment, begin, end});
            }
            position = end;
            if (i < a.size() && a[i].end <= position) ++i;
            if (j < b.size() && b[j].end <= position) ++j;
        }
        return result;
    }

private:
    void higher(Pieces& result, Index a, Index b, double begin, double end) const {
        const auto above = [&](double position) {
            return height_of_segment(x_, y_, a, position) - height_of_segment(x_, y_, b, position);
        };
        const double first = above(begin), last = above(end);
        if (first >= 0.0 && last >= 0.0) return append(result, {a, begin, end});
        if (first <= 0.0 && last <= 0.0) return append(result, {b, begin, end});
        const double crossing = std::clamp(begin + (end - begin) * (first / (first - last)), begin, end);
        append(result, {first > 0.0 ? a : b, begin, crossing});
        append(result, {first > 0.0 ? b : a, crossing, end});
    }

    const Array1D& x_;
    const Array1D& y_;
};

/// Parts between turning points, each from left to right.
std::vector<Pieces> monotonic_stretches(const Array1D& x) {
    std::vector<Pieces> stretches;
    int direction = 0;
    for (Index i = 0; i + 1 < x.size(); ++i) {
        const int here = x[i + 1] > x[i] ? 1 : x[i + 1] < x[i] ? -1 : 0;
        if (here == 0) continue;
        if (here != direction) stretches.emplace_back();
        direction = here;
        stretches.back().push_back({i, std::min(x[i], x[i + 1]), std::max(x[i], x[i + 1])});
    }
    for (auto& stretch : stretches)
        if (stretch.front().begin > stretch.back().begin) std::reverse(stretch.begin(), stretch.end());
    return stretches;
}

}  // namespace

double height_of_segment(const Array1D& x, const Array1D& y, Index segment, double position) {
    const double width = x[segment + 1] - x[segment];
    if (position == x[segment] || width == 0.0) return y[segment];
    if (position == x[segment + 1]) return y[segment + 1];
    return y[segment] + (y[segment + 1] - y[segment]) * ((position - x[segment]) / width);
}

std::vector<VisiblePiece> upper_envelope(const Array1D& x, const Array1D& y) {
    auto parts = monotonic_stretches(x);
    if (parts.empty()) return {};
    const Merge merge(x, y);
    while (parts.size() > 1) {
        std::vector<Pieces> halved;
        for (std::size_t i = 0; i + 1 < parts.size(); i += 2) halved.push_back(merge(parts[i], parts[i + 1]));
        if (parts.size() % 2 == 1) halved.push_back(std::move(parts.back()));
        parts = std::move(halved);
    }
    return std::move(parts.front());
}

}  // namespace setae::topography
