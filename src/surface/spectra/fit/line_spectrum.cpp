// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/line_spectrum.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/spectral_fit/hat_node.hpp"

namespace setae::spectral_fit {
namespace {

constexpr Index max_nodes = 1000;

/// Means of C1D of a node over the cell around 1, by the distance of the node of height 1 above that cell in nodes: −1,
/// 0, 1, …
class CellMeans {
public:
    explicit CellMeans(hat_node::LineIntegrals (*integrals)(double)) {
        const double half = std::exp(0.5 * node_spacing), width = half - 1.0 / half;
        for (Index lag = -1; lag <= max_nodes; ++lag) {
            const double node = std::exp(node_spacing * static_cast<double>(lag));
            means_.push_back(node * node * (integrals(half / node).zeroth - integrals(1.0 / (half * node)).zeroth) /
                             width);
        }
    }
    [[nodiscard]] double operator()(Index lag) const {
        return lag < -1 ? 0.0 : means_[static_cast<std::size_t>(lag + 1)];
    }

private:
    std::vector<double> means_;
};

void require(const ArrayView1D& nodes, const ArrayView1D& C_iso) {
    const Index n = nodes.size();
    if (n != C_iso.size() || n < 2 || n > max_nodes)
        throw InvalidArgument(fmt::format("{} nodes and {} values of C_iso; expected as many of each, 2 to {}", n,
                                          C_iso.size(), max_nodes));
    for (Index i = 1; i < n; ++i)
        if (std::abs(std::log(nodes[i] / nodes[i - 1]) - node_spacing) > 1e-6)
            throw InvalidArgument(fmt::format("nodes {} and {} 1/m; expected a ratio of e^h = {}", nodes[i - 1],
                                              nodes[i], std::exp(node_spacing)));
}

}  // namespace

Array1D line_spectrum(const ArrayView1D& nodes, const ArrayView1D& C_iso) {
    static const CellMeans whole(hat_node::line_integrals), lower_half(hat_node::line_integrals_of_lower_half),
        disc(hat_node::line_integrals_of_disc);
    require(nodes, C_iso);
    const Index n = nodes.size(), last = n - 1;
    Array1D C1D(n);
    for (Index b = 0; b < n; ++b) {
        double sum = 0.0;
        for (Index i = std::max<Index>(b - 1, 0); i < last; ++i) sum += C_iso[i] * whole(i - b);
        sum += C_iso[last] * lower_half(last - b);
        // below the first node: a disc whose outer edge is already the lower half of the node
        sum += C_iso[0] * (disc(-b) - lower_half(-b));
        C1D[b] = nodes[b] * sum;
    }
    return C1D;
}

}  // namespace setae::spectral_fit
