// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>

#include "setae/core/arrays.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/map_transform.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::scales {

/// Half spectra along y of the rows of a map, each padded with zeros to the length of the transform: nx · modes values.
using RowSpectra = fourier::Buffer<fourier::Complex>;

/// `load(i, line)` writes the first `points` values of row i; the rest is zero.
inline void transform_rows(Index rows, Index points, const fourier::RealTransform& along_y,
                           const std::function<void(Index, double*)>& load, RowSpectra& spectra,
                           parallel::Threads threads) {
    const Index modes = along_y.modes();
    spectra.resize(static_cast<std::size_t>(rows * modes));
    parallel::for_each_index(static_cast<std::size_t>(fourier::block_count(rows)), threads, [&](std::size_t block) {
        fourier::Buffer<double> line(static_cast<std::size_t>(along_y.points()), 0.0);
        const Index first = static_cast<Index>(block) * fourier::lines_per_block;
        for (Index i = first; i < std::min(rows, first + fourier::lines_per_block); ++i) {
            load(i, line.data());
            std::fill(line.begin() + points, line.end(), 0.0);
            along_y.forward(line.data(), spectra.data() + i * modes);
        }
    });
}

/// Some neighbouring columns of row spectra, each contiguous and followed by zeros.
class Columns {
public:
    explicit Columns(Index padded)
        : padded_(padded),
          stride_((padded + 3) / 4 * 4 + 4),
          values_(static_cast<std::size_t>(fourier::lines_per_block * stride_)) {}

    void take(const RowSpectra& spectra, Index rows, Index modes, Index first, Index count) {
        for (Index i = 0; i < rows; ++i) {
            const fourier::Complex* row = spectra.data() + i * modes + first;
            for (Index m = 0; m < count; ++m) column(m)[i] = row[m];
        }
        for (Index m = 0; m < count; ++m) std::fill(column(m) + rows, column(m) + padded_, fourier::Complex{});
    }
    void put(RowSpectra& spectra, Index rows, Index modes, Index first, Index count) const {
        for (Index i = 0; i < rows; ++i) {
            fourier::Complex* row = spectra.data() + i * modes + first;
            for (Index m = 0; m < count; ++m) row[m] = column(m)[i];
        }
    }
    [[nodiscard]] fourier::Complex* column(Index m) { return values_.data() + m * stride_; }
    [[nodiscard]] const fourier::Complex* column(Index m) const { return values_.data() + m * stride_; }

private:
    Index padded_, stride_;
    fourier::Buffer<fourier::Complex> values_;
};

}  // namespace setae::scales
