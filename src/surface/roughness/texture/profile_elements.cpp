// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "profile_lines.hpp"
#include "profile_parts.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/texture/profile_parameters.hpp"

namespace setae::texture {
namespace {

/// A hill (sign 1) or dale (−1) between two crossings of the mean line.
struct Part {
    double begin, end;
    int sign;
    double height;  ///< over or below the mean line
    bool whole;     ///< crossings on both sides
};

std::vector<Part> parts_between_crossings(const Points& points, double mean_line) {
    const auto z = [&](Index i) { return points.heights[i] - mean_line; };
    const auto sign = [&](Index i) { return z(i) < 0.0 ? -1 : 1; };
    std::vector<Part> parts{{points.positions[0], points.positions[0], sign(0), std::abs(z(0)), false}};
    for (Index i = 1; i < points.heights.size(); ++i) {
        auto& part = parts.back();
        if (sign(i) == part.sign) {
            part.height = std::max(part.height, std::abs(z(i)));
            continue;
        }
        const double x =
            points.positions[i - 1] + (points.positions[i] - points.positions[i - 1]) * z(i - 1) / (z(i - 1) - z(i));
        part.end = x;
        parts.push_back({x, x, sign(i), std::abs(z(i)), true});
    }
    parts.back().end = points.positions[points.positions.size() - 1];
    parts.back().whole = false;
    return parts;
}

/// Parts below the thresholds are joined to the previous one; neighbours of one sign become one.
std::vector<Part> significant(const std::vector<Part>& parts, double height, double length) {
    std::vector<Part> kept;
    for (const auto& part : parts) {
        const bool counts = !part.whole || (part.height >= height && part.end - part.begin >= length);
        if (!kept.empty() && (!counts || kept.back().sign == part.sign)) {
            kept.back().end = part.end;
            if (kept.back().sign == part.sign) kept.back().height = std::max(kept.back().height, part.height);
            if (counts) kept.back().whole = kept.back().whole && part.whole;
        } else {
            kept.push_back(part);
        }
    }
    return kept;
}

}  // namespace

ProfileElements profile_elements(const MeasurementView& line, double height, double length, double mean_line) {
    const auto parts = significant(parts_between_crossings(points_of(line), mean_line), height, length);
    std::vector<double> lengths, heights;
    for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
        if (!parts[k].whole) continue;
        if (!parts[k + 1].whole) break;
        lengths.push_back(parts[k + 1].end - parts[k].begin);
        heights.push_back(parts[k].height + parts[k + 1].height);
        ++k;
    }
    if (lengths.empty()) return {undefined, undefined, undefined, undefined, 0};
    const auto n = static_cast<Index>(lengths.size());
    const Eigen::Map<const Array1D> all_lengths(lengths.data(), n), all_heights(heights.data(), n);
    const double RSm = all_lengths.mean(), Rc = all_heights.mean();
    return {RSm, std::sqrt((all_lengths - RSm).square().mean()), Rc, std::sqrt((all_heights - Rc).square().mean()), n};
}

}  // namespace setae::texture
