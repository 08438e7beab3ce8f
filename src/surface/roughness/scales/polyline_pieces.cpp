// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyline_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/spectra/log_grid.hpp"

namespace setae::scales {
namespace {

/// The polyline at x + offset while x moves to the right.
class Walker {
public:
    Walker(const topography::Profile& profile, const Shift& shift, double start) : profile_(profile), shift_(shift) {
        const auto& x = profile.positions;
        const auto* place = std::upper_bound(x.data() + 1, x.data() + x.size() - 1, start + shift.offset);
        segment_ = place - x.data() - 1;
    }
    [[nodiscard]] double segment_end() const {
        return segment_ + 2 < profile_.positions.size() ? profile_.positions[segment_ + 1] - shift_.offset
                                                        : std::numeric_limits<double>::infinity();
    }
    void pass(double x) {
        while (segment_end() <= x) ++segment_;
    }
    /// Height on the current segment, relative to the first height of the polyline.
    [[nodiscard]] double height(double x) const {
        const auto& X = profile_.positions;
        const auto& H = profile_.heights;
        const double share = (x + shift_.offset - X[segment_]) / (X[segment_ + 1] - X[segment_]);
        return (H[segment_] - H[0]) + share * (H[segment_ + 1] - H[segment_]);
    }
    [[nodiscard]] double weight() const { return shift_.weight; }

private:
    const topography::Profile& profile_;
    Shift shift_;
    Index segment_;
};

double value(const std::vector<Walker>& walkers, double x) {
    double sum = 0.0;
    for (const auto& walker : walkers) sum += walker.weight() * walker.height(x);
    return sum;
}

/// ∫ g^k over a piece on which g changes linearly from a to b.
void add_piece(double a, double b, double length, PieceMoments& sums) {
    const double u = a - sums.origin, v = b - sums.origin;
    sums.length += length;
    sums.moments[0] += length * (u + v) / 2.0;
    sums.moments[1] += length * (u * u + u * v + v * v) / 3.0;
    sums.moments[2] += length * (u + v) * (u * u + v * v) / 4.0;
    sums.moments[3] += length * (u * u * u * u + u * v * (u * u + u * v + v * v) + v * v * v * v) / 5.0;
    sums.minimum = std::min({sums.minimum, a, b});
    sums.maximum = std::max({sums.maximum, a, b});
}

}  // namespace

void require_polyline(const topography::Profile& profile) {
    if (profile.heights.isNaN().any())
        throw UndefinedDataError(fmt::format("{}: a height of a polyline is undefined; leave out this point",
                                             topography::label(profile.metadata)));
    topography::validate(profile);
}

PieceMoments difference_moments(const topography::Profile& profile, std::span<const Shift> shifts) {
    const auto [lowest, highest] = std::minmax_element(
        shifts.begin(), shifts.end(), [](const Shift& a, const Shift& b) { return a.offset < b.offset; });
    double x = profile.positions[0] - lowest->offset;
    const double end = profile.positions[profile.positions.size() - 1] - highest->offset;
    PieceMoments sums;
    if (!(end > x)) return sums;
    std::vector<Walker> walkers;
    for (const auto& shift : shifts) walkers.emplace_back(profile, shift, x);
    sums.origin = sums.minimum = sums.maximum = value(walkers, x);
    while (x < end) {
        double next = end;
        for (const auto& walker : walkers) next = std::min(next, walker.segment_end());
        if (next > x) add_piece(value(walkers, x), value(walkers, next), next - x, sums);
        for (auto& walker : walkers) walker.pass(next);
        x = next;
    }
    return sums;
}

Array1D distances_on_grid(int per_decade, double shortest, double longest) {
    const spectra::LogGrid grid{per_decade};
    std::vector<double> distances;
    const Index first = grid.bin_of(shortest * (1.0 + 1e-12));
    for (Index b = first; grid.edge(b) < longest * (1.0 - 1e-12); ++b)
        if (grid.edge(b) >= shortest * (1.0 - 1e-12)) distances.push_back(grid.edge(b));
    return Eigen::Map<const Array1D>(distances.data(), static_cast<Index>(distances.size()));
}

}  // namespace setae::scales
