// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_samples.hpp"

#include <functional>

namespace setae::io::tests {

std::vector<FormatSample> format_samples() {
    const std::vector<std::function<std::vector<FormatSample>()>> makers{
        // exchange

        // arrays
        netcdf_samples,
        npy_samples,
        npz_samples,
        mat_samples,
        hdf5_samples,
        datx_samples,
        jpk_hdf5_samples,

        // scanning probes
        nanoscope_samples,

        // optical and stylus profilers

        // text and sheets
    };
    std::vector<FormatSample> samples;
    for (const auto& make : makers)
        for (auto& sample : make()) samples.push_back(std::move(sample));
    return samples;
}

Array2D lopsided_heights(Index nx, Index ny, double unit) {
    Array2D heights(nx, ny);
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) heights(i, j) = unit * static_cast<double>(1 + 3 * i + 100 * j + (7 * i + 13 * j) % 11);
    return heights;
}

}  // namespace setae::io::tests
