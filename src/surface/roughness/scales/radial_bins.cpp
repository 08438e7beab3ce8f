// SPDX-License-Identifier: GPL-3.0-or-later
#include "radial_bins.hpp"

#include <algorithm>
#include <cmath>

#include "autocorrelation_result.hpp"

namespace setae::scales {
namespace {

constexpr double rounding = 1e-12;  ///< as LogGrid: a length equal to an edge belongs to the bin above

}  // namespace

RadialBins::RadialBins(const spectra::LogGrid& grid, std::array<double, 2> pixel_size, double longest)
    : pixel_size_(pixel_size) {
    const Index first = grid.bin_of(std::min(pixel_size[0], pixel_size[1]));
    for (Index bin = first; grid.edge(bin) * (1.0 - rounding) <= longest; ++bin)
        edges_.push_back(grid.edge(bin) * (1.0 - rounding));
    edges_.push_back(longest * (1.0 + rounding));
}

void RadialBins::add(Index k, const double* values, Index y, double weight, Row& sums) const {
    const double x = static_cast<double>(k) * pixel_size_[0];
    if (x >= edges_.back()) return;
    // the first l >= 0 whose vector is at least as long as an edge
    const auto first_beyond = [&](double edge) {
        if (x >= edge) return Index{0};
        auto l = static_cast<Index>(std::ceil(std::sqrt(edge * edge - x * x) / pixel_size_[1]));
        const auto length = [&](Index at) { return std::hypot(x, static_cast<double>(at) * pixel_size_[1]); };
        while (l > 0 && length(l - 1) >= edge) --l;
        while (length(l) < edge) ++l;
        return std::min(l, y + 1);
    };
    const auto add_segment = [&](Index from, Index to, Sums& bin) {  // l = from … to − 1
        if (from >= to) return;
        const auto segment = Eigen::Map<const Array1D>(values + y + from, to - from);
        const Array1D lengths =
            ((Array1D::LinSpaced(to - from, static_cast<double>(from), static_cast<double>(to - 1)) * pixel_size_[1])
                 .square() +
             x * x)
                .sqrt();
        const double sum = segment.sum();
        if (!std::isnan(sum)) {
            bin.value += weight * sum;
            bin.distance += weight * lengths.sum();
            bin.vectors += weight * static_cast<double>(to - from);
        } else {
            const Eigen::Array<bool, Eigen::Dynamic, 1> defined = !segment.isNaN();
            bin.value += weight * defined.select(segment, 0.0).sum();
            bin.distance += weight * defined.select(lengths, 0.0).sum();
            bin.vectors += weight * static_cast<double>(defined.count());
        }
    };
    Index from = first_beyond(edges_.front());
    for (Index b = 0; b < size(); ++b) {
        const Index to = first_beyond(edges_[static_cast<std::size_t>(b) + 1]);
        auto& bin = sums[static_cast<std::size_t>(b)];
        add_segment(from, to, bin);
        add_segment(1 - to, 1 - std::max<Index>(from, 1), bin);
        from = to;
    }
}

FunctionOfScale radial_average(const RadialBins::Row& sums, const topography::Metadata& metadata) {
    const auto used = std::count_if(sums.begin(), sums.end(), [](const auto& bin) { return bin.vectors > 0.0; });
    auto result = empty_autocorrelation(used, metadata);
    result.quantity = "autocorrelation_of_area";
    Index b = 0;
    for (const auto& bin : sums) {
        if (!(bin.vectors > 0.0)) continue;
        result.distance[b] = bin.distance / bin.vectors;
        result.value[b] = bin.value / bin.vectors;
        result.count[b++] = bin.vectors;
    }
    return result;
}

}  // namespace setae::scales
