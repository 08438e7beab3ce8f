// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_band.hpp"

#include <algorithm>
#include <cmath>

namespace setae::imaging {
namespace {

struct Nearest {
    double squared = 1e300;
    Index index = 0;
    double fraction = 0;
    double side = 0;
    bool beyond_end = false;
    long pixel = 0;
};

}  // namespace

EdgeBand::EdgeBand(const FramePixels& pixels, const PixelMask& hidden)
    : pixels_(pixels), hidden_(hidden), slot_(static_cast<std::size_t>(pixels.size()), -1) {}

std::vector<BandPixel> EdgeBand::near(const PlaneCurve& curve, double reach) {
    const long rows = pixels_.rows(), columns = pixels_.cols();
    const Index n = curve.size(), pieces = curve.closed ? n : n - 1;
    std::vector<Nearest> nearest;
    nearest.reserve(static_cast<std::size_t>(static_cast<double>(n) * 2.5 * reach));
    for (Index k = 0; k < pieces; ++k) {
        const Index next = curve.at(k + 1);
        const double ax = curve.x[k], ay = curve.y[k], ex = curve.x[next] - ax, ey = curve.y[next] - ay,
                     squared_length = std::max(1e-300, ex * ex + ey * ey);
        const long first_row = std::max(0L, static_cast<long>(std::ceil(std::min(ay, ay + ey) - reach))),
                   last_row = std::min(rows - 1, static_cast<long>(std::floor(std::max(ay, ay + ey) + reach)));
        const long first_column = std::max(0L, static_cast<long>(std::ceil(std::min(ax, ax + ex) - reach))),
                   last_column = std::min(columns - 1, static_cast<long>(std::floor(std::max(ax, ax + ex) + reach)));
        for (long row = first_row; row <= last_row; ++row)
            for (long column = first_column; column <= last_column; ++column) {
                const double px = static_cast<double>(column) - ax, py = static_cast<double>(row) - ay;
                const double along = (px * ex + py * ey) / squared_length, t = std::clamp(along, 0.0, 1.0);
                const double dx = px - t * ex, dy = py - t * ey, squared = dx * dx + dy * dy;
                if (squared > reach * reach || hidden_(row, column) != 0) continue;
                const long pixel = row * columns + column;
                auto& slot = slot_[static_cast<std::size_t>(pixel)];
                if (slot < 0) {
                    slot = static_cast<std::int32_t>(nearest.size());
                    nearest.push_back({});
                }
                auto& best = nearest[static_cast<std::size_t>(slot)];
                if (squared >= best.squared) continue;
                const bool beyond = !curve.closed && ((k == 0 && along < 0) || (k == pieces - 1 && along > 1));
                best = {squared, k, t, ey * px - ex * py, beyond, pixel};
            }
    }
    std::vector<BandPixel> found;
    found.reserve(nearest.size());
    for (const auto& best : nearest) {
        slot_[static_cast<std::size_t>(best.pixel)] = -1;
        if (!best.beyond_end)
            found.push_back({best.index, best.fraction, std::copysign(std::sqrt(best.squared), best.side),
                             static_cast<double>(pixels_.data()[best.pixel])});
    }
    return found;
}

}  // namespace setae::imaging
