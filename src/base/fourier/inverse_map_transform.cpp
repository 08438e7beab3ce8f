// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/inverse_map_transform.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/map_transform.hpp"

namespace setae::fourier {
namespace inverse_map {

/// A half spectrum inside its map: the complex values of lines 1 … inner are in the rows, those of lines 0 and ny/2,
/// which are real after the transform along x, are separate.
struct HalfSpectrum {
    Eigen::Ref<Array2D> map;
    Index inner;  ///< lines other than 0 and ny/2
    Buffer<double> mean_line, highest_line;

    explicit HalfSpectrum(Eigen::Ref<Array2D> target)
        : map(target),
          inner((map.cols() - 1) / 2),
          mean_line(extent(map.rows())),
          highest_line(map.cols() % 2 == 0 ? extent(map.rows()) : 0) {}
};

}  // namespace inverse_map

using inverse_map::HalfSpectrum;

namespace {

void transform_edge(const SpectrumLine& load, const ComplexTransform& along_x, Index m, Buffer<double>& out) {
    Buffer<Complex> line(out.size());
    load(m, line.data());
    along_x.apply(line.data());
    std::transform(line.begin(), line.end(), out.begin(), [](const Complex& value) { return value.real(); });
}

void transform_block(const SpectrumLine& load, const ComplexTransform& along_x, Index block, HalfSpectrum& half) {
    const Index nx = along_x.points(), first = block * lines_per_block,
                lines = std::min(lines_per_block, half.inner - first);
    const Index stride = (nx + 3) / 4 * 4 + 4;  // avoids that lines of a block share the same places of the cache
    thread_local Buffer<Complex> buffer;
    buffer.resize(extent(lines * stride));
    for (Index m = 0; m < lines; ++m) {
        load(1 + first + m, buffer.data() + m * stride);
        along_x.apply(buffer.data() + m * stride);
    }
    for (Index i = 0; i < nx; ++i) {
        double* row = half.map.data() + i * half.map.outerStride() + 2 * first;
        for (Index m = 0; m < lines; ++m) {
            const Complex value = buffer[extent(m * stride + i)];
            row[2 * m] = value.real();
            row[2 * m + 1] = value.imag();
        }
    }
}

void transform_row(const InverseRealTransform& along_y, Index i, HalfSpectrum& half) {
    thread_local Buffer<Complex> modes;
    thread_local Buffer<double> line;
    modes.resize(extent(along_y.modes()));
    line.resize(extent(along_y.points()));
    double* row = half.map.data() + i * half.map.outerStride();
    modes[0] = half.mean_line[extent(i)];
    for (Index m = 0; m < half.inner; ++m) modes[extent(m + 1)] = {row[2 * m], row[2 * m + 1]};
    if (!half.highest_line.empty()) modes.back() = half.highest_line[extent(i)];
    along_y.apply(modes.data(), line.data());
    std::copy(line.begin(), line.end(), row);
}

}  // namespace

struct InverseMapTransform::Parts {
    HalfSpectrum half;
    InverseRealTransform along_y;
};

InverseMapTransform::InverseMapTransform(const SpectrumLine& load, Eigen::Ref<Array2D> map, parallel::Threads threads) {
    const Index nx = map.rows(), ny = map.cols();
    if (nx < 1 || ny < 1)
        throw InvalidArgument(fmt::format("a transform to {} x {} points; expected at least 1 x 1", nx, ny));
    const ComplexTransform along_x(nx, ComplexTransform::Sign::plus);
    parts_ = std::make_unique<Parts>(HalfSpectrum(map), InverseRealTransform(ny));
    auto& half = parts_->half;
    const Index blocks = block_count(half.inner), edges = ny % 2 == 0 ? 2 : 1;
    parallel::for_each_index(extent(blocks + edges), threads, [&](std::size_t task) {
        const Index index = static_cast<Index>(task);
        if (index < blocks) transform_block(load, along_x, index, half);
        else if (index == blocks) transform_edge(load, along_x, 0, half.mean_line);
        else transform_edge(load, along_x, ny / 2, half.highest_line);
    });
}

InverseMapTransform::~InverseMapTransform() = default;
InverseMapTransform::InverseMapTransform(InverseMapTransform&&) noexcept = default;
InverseMapTransform& InverseMapTransform::operator=(InverseMapTransform&&) noexcept = default;

void InverseMapTransform::make_rows(Index first, Index last, parallel::Threads threads) {
    parallel::for_each_index(extent(block_count(last - first)), threads, [&](std::size_t block) {
        const Index begin = first + static_cast<Index>(block) * lines_per_block;
        for (Index i = begin; i < std::min(last, begin + lines_per_block); ++i)
            transform_row(parts_->along_y, i, parts_->half);
    });
}

void inverse_transform_map(const SpectrumLine& load, Eigen::Ref<Array2D> map, parallel::Threads threads) {
    InverseMapTransform(load, map, threads).make_rows(0, map.rows(), threads);
}

}  // namespace setae::fourier
