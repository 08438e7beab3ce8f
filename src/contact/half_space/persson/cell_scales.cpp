// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/persson/cell_scales.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "first_nodes.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::persson {
namespace {

constexpr double step = 0.01;  ///< of V from node to node, over V

/// Contribution of modes of one length.
struct Shell {
    double wavevector, variance, energy;
};

std::vector<Shell> shells_of(const spectra::SpectralDensity& C_iso, const half_space::Grid& grid,
                             const half_space::Body& body) {
    const double x = 2.0 * pi / grid.size_x, y = 2.0 * pi / grid.size_y;
    std::vector<Shell> shells;
    for (Index k = 0; k <= grid.nx / 2; ++k)
        for (Index m = k == 0 ? 1 : 0; m <= grid.ny / 2; ++m) {
            const double q = std::hypot(x * static_cast<double>(k), y * static_cast<double>(m));
            const double density = C_iso(q);
            if (!(density > 0.0)) continue;
            const double modes = (k > 0 ? 2.0 : 1.0) * (m > 0 ? 2.0 : 1.0), stiffness = half_space::stiffness(q, body);
            const double power = modes * density / grid.area();
            shells.push_back({q, stiffness * stiffness * power, 0.5 * stiffness * power});
        }
    std::sort(shells.begin(), shells.end(), [](const Shell& a, const Shell& b) { return a.wavevector < b.wavevector; });
    return shells;
}

/// Nodes of V and U in the order of q.
class Nodes {
public:
    explicit Nodes(double lowest) : nodes_{{lowest, 0.0, 0.0}} {}

    [[nodiscard]] double variance() const { return nodes_.back().variance; }
    void rise(const Shell& added) {
        const Shell from = nodes_.back();
        const auto add = [&](double share) {
            nodes_.push_back(
                {added.wavevector, from.variance + share * added.variance, from.energy + share * added.energy});
        };
        if (from.variance == 0.0)
            for (double share = std::pow(growth, -first_nodes); share < 5.0 * step; share *= growth) add(share);
        const double start = nodes_.back().variance - from.variance;
        const auto steps =
            static_cast<int>(std::ceil((added.variance - start) / (step * std::max(from.variance, added.variance))));
        for (int i = 1; i <= steps; ++i)
            add((start + (added.variance - start) * static_cast<double>(i) / static_cast<double>(steps)) /
                added.variance);
    }
    [[nodiscard]] Scales scales(const half_space::Body& body) const {
        const auto n = static_cast<Index>(nodes_.size());
        Scales scales{Array1D(n), Array1D(n), Array1D(n), Array1D(n)};
        for (Index i = 0; i < n; ++i) {
            const Shell& node = nodes_[static_cast<std::size_t>(i)];
            scales.wavevector[i] = node.wavevector;
            scales.stiffness[i] = half_space::stiffness(node.wavevector, body);
            scales.pressure_variance[i] = node.variance;
            scales.stored_energy[i] = node.energy;
        }
        return scales;
    }

private:
    std::vector<Shell> nodes_;
};

}  // namespace

Scales scales_of_cell(const spectra::SpectralDensity& C_iso, const half_space::Grid& grid,
                      const half_space::Body& body) {
    half_space::require(grid);
    half_space::require(body);
    const auto shells = shells_of(C_iso, grid, body);
    if (shells.empty()) throw UndefinedDataError("no wave of the cell has power");
    Nodes nodes(shells.front().wavevector);
    Shell gathered{};
    for (std::size_t i = 0; i < shells.size(); ++i) {
        gathered.wavevector = shells[i].wavevector;
        gathered.variance += shells[i].variance;
        gathered.energy += shells[i].energy;
        const bool last = i + 1 == shells.size(),
                   others = last || shells[i + 1].wavevector > shells[i].wavevector * (1.0 + 1e-9);
        if (!last && (!others || gathered.variance < step * nodes.variance())) continue;
        nodes.rise(gathered);
        gathered = {};
    }
    return nodes.scales(body);
}

}  // namespace setae::persson
