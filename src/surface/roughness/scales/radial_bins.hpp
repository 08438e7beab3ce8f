// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/fourier/buffer.hpp"
#include "setae/scales/function_of_scale.hpp"

namespace setae::scales {

/// Bins of the lengths of lag vectors, and the assignment of a row of vectors to bins.
class RadialBins {
public:
    RadialBins(const spectra::LogGrid& grid, std::array<double, 2> pixel_size, double longest);

    [[nodiscard]] Index size() const { return static_cast<Index>(edges_.size()) - 1; }

    /// Sums of one bin.
    struct Sums {
        double distance = 0.0, value = 0.0, vectors = 0.0;
    };
    using Row = std::vector<Sums>;

    /// Adds row k of lag vectors, l = −y … y, each counted `weight` times; undefined values are left out. `values` is
    /// aligned to a cache line.
    void add(Index k, const double* values, Index y, double weight, Row& sums) const;

private:
    std::vector<double> edges_;  ///< [m], the last just above the longest distance
    std::array<double, 2> pixel_size_;
};

/// The bins with vectors, as an autocorrelation.
[[nodiscard]] FunctionOfScale radial_average(const RadialBins::Row& sums, const topography::Metadata& metadata);

}  // namespace setae::scales
