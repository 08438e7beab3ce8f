// SPDX-License-Identifier: GPL-3.0-or-later
#include "envelope_profile.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "upper_envelope.hpp"

namespace setae::topography {
namespace {

struct Vertex {
    double x, y, error;
};

/// A part of the envelope between two jumps.
using Run = std::vector<Vertex>;

Vertex between(const Vertex& a, const Vertex& b, double x) {
    const double t = (x - a.x) / (b.x - a.x);
    return {x, a.y + t * (b.y - a.y), a.error + t * (b.error - a.error)};
}

/// The part of a run beyond `x`, with a new vertex there.
Run from(const Run& run, double x) {
    Run part;
    for (std::size_t i = 1; i < run.size(); ++i) {
        if (run[i].x <= x) continue;
        if (part.empty()) part.push_back(between(run[i - 1], run[i], x));
        part.push_back(run[i]);
    }
    return part;
}

Run until(const Run& run, double x) {
    Run part;
    for (std::size_t i = 0; i < run.size(); ++i) {
        if (run[i].x < x) {
            part.push_back(run[i]);
            continue;
        }
        part.push_back(between(run[i - 1], run[i], x));
        break;
    }
    return part;
}

std::vector<Run> runs_between_jumps(const std::vector<VisiblePiece>& pieces, const OrientedCurve& curve,
                                    const Array1D& error) {
    const double rounding = 1e-12 * (curve.y.maxCoeff() - curve.y.minCoeff());
    const auto vertex = [&](Index segment, double x) {
        return Vertex{x, height_of_segment(curve.x, curve.y, segment, x),
                      error.size() > 0 ? height_of_segment(curve.x, error, segment, x) : 0.0};
    };
    std::vector<Run> runs;
    for (const auto& piece : pieces) {
        const auto first = vertex(piece.segment, piece.begin);
        if (runs.empty() || std::abs(runs.back().back().y - first.y) > rounding) runs.push_back({first});
        runs.back().push_back(vertex(piece.segment, piece.end));
    }
    return runs;
}

[[nodiscard]] std::vector<Run> with_room_at_jumps(const std::vector<Run>& runs, double step) {
    std::vector<Run> result = runs;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto& run = runs[i];
        const double left = run.front().x, right = run.back().x, room = std::min(step, (right - left) / 3.0);
        const bool higher_before = i > 0 && runs[i - 1].back().y > run.front().y;
        const bool higher_after = i + 1 < runs.size() && runs[i + 1].front().y > run.back().y;
        if (higher_before) result[i] = from(result[i], left + room);
        if (higher_after) result[i] = until(result[i], right - room);
    }
    return result;
}

}  // namespace

Visible visible_profile(const OrientedCurve& curve) {
    auto pieces = upper_envelope(curve.x, curve.y);
    const auto backwards = [&](const VisiblePiece& piece) {
        return curve.x[piece.segment + 1] < curve.x[piece.segment];
    };
    while (!pieces.empty() && backwards(pieces.back())) pieces.pop_back();
    pieces.erase(pieces.begin(), std::find_if_not(pieces.begin(), pieces.end(), backwards));
    Visible visible;
    if (pieces.empty()) return visible;
    for (const auto& [segment, begin, end] : pieces) {
        const double x = curve.x[segment], width = curve.x[segment + 1] - x, start = curve.along[segment],
                     length = curve.along[segment + 1] - start;
        const double one = start + length * ((begin - x) / width), other = start + length * ((end - x) / width);
        visible.seen.push_back({std::min(one, other), std::max(one, other)});
        visible.length += std::hypot(end - begin, height_of_segment(curve.x, curve.y, segment, end) -
                                                      height_of_segment(curve.x, curve.y, segment, begin));
    }
    const auto error = curve.height_error();
    const double step = (pieces.back().end - pieces.front().begin) / static_cast<double>(pieces.size());

    std::vector<Vertex> vertices;
    for (const auto& run : with_room_at_jumps(runs_between_jumps(pieces, curve, error), step))
        vertices.insert(vertices.end(), run.begin(), run.end());
    const auto n = static_cast<Index>(vertices.size());
    const auto column = [&](auto of) {
        return Array1D::NullaryExpr(n, [&](Index i) { return of(vertices[static_cast<std::size_t>(i)]); }).eval();
    };
    visible.profile.positions = column([](const Vertex& v) { return v.x; });
    visible.profile.heights = column([](const Vertex& v) { return v.y; });
    if (error.size() > 0) visible.profile.standard_error = column([](const Vertex& v) { return v.error; });
    return visible;
}

}  // namespace setae::topography
