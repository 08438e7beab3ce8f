// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/contact_line/line_motion.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::contact_line {
namespace {

struct Cell {
    Index angle = 0;  ///< counted on through 2π, so that a cluster across the first angle is in one piece
    Index ring = 0;
};

/// Cells of a cylinder that are in and not yet counted.
class Cells {
public:
    Cells(const Passage& passage, ClusterKind kind, double threshold)
        : open_(passage.speed.rows(), passage.speed.cols()) {
        const double v = passage.mean_speed;
        if (kind == ClusterKind::jumps) open_ = passage.speed > threshold * v;
        else open_ = passage.speed < v / threshold;
    }

    [[nodiscard]] Index angles() const { return open_.rows(); }
    [[nodiscard]] Index rings() const { return open_.cols(); }

    /// The cells that hang together with this one, which are then counted; none where it is not in.
    std::vector<Cell> taken_from(Index angle, Index ring) {
        std::vector<Cell> found;
        take({angle, ring}, found);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto cell = found[i];
            take({cell.angle + 1, cell.ring}, found);
            take({cell.angle - 1, cell.ring}, found);
            take({cell.angle, cell.ring + 1}, found);
            take({cell.angle, cell.ring - 1}, found);
        }
        return found;
    }

private:
    void take(const Cell& cell, std::vector<Cell>& found) {
        if (cell.ring < 0 || cell.ring >= rings()) return;
        bool& open = open_((cell.angle % angles() + angles()) % angles(), cell.ring);
        if (open) found.push_back(cell);
        open = false;
    }

    Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> open_;
};

Cluster as_cluster(const std::vector<Cell>& cells, const Passage& passage) {
    const double step = 2.0 * pi / static_cast<double>(passage.speed.rows());
    const auto [first_angle, last_angle] =
        std::minmax_element(cells.begin(), cells.end(), [](auto& a, auto& b) { return a.angle < b.angle; });
    const auto [first_ring, last_ring] =
        std::minmax_element(cells.begin(), cells.end(), [](auto& a, auto& b) { return a.ring < b.ring; });
    Cluster cluster{.cells = static_cast<Index>(cells.size())};
    double angle = 0.0, radius = 0.0;
    for (const auto& cell : cells) {
        const double area = passage.ring[cell.ring] * step * passage.width;
        cluster.area += area;
        angle += area * static_cast<double>(cell.angle) * step;
        radius += area * passage.ring[cell.ring];
    }
    cluster.radius = radius / cluster.area;
    cluster.angle = std::remainder(angle / cluster.area, 2.0 * pi);
    const auto around = std::min(passage.speed.rows(), last_angle->angle - first_angle->angle + 1);
    cluster.along = static_cast<double>(around) * step * cluster.radius;
    cluster.across = static_cast<double>(last_ring->ring - first_ring->ring + 1) * passage.width;
    return cluster;
}

}  // namespace

std::vector<Cluster> clusters(const Passage& passage, ClusterKind kind, double threshold) {
    if (!(threshold > 1.0))
        throw InvalidArgument(fmt::format("a threshold of {} times the mean speed; expected above 1", threshold));
    Cells cells(passage, kind, threshold);
    std::vector<Cluster> found;
    for (Index j = 0; j < cells.angles(); ++j)
        for (Index k = 0; k < cells.rings(); ++k)
            if (const auto together = cells.taken_from(j, k); !together.empty())
                found.push_back(as_cluster(together, passage));
    std::stable_sort(found.begin(), found.end(), [](const Cluster& a, const Cluster& b) { return a.area > b.area; });
    return found;
}

}  // namespace setae::contact_line
