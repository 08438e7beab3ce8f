// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/map_transform.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/fourier/buffer.hpp"

namespace setae::fourier {
namespace {

/// Distance of lines of a block: a multiple of cache lines of `Value`, and never a power of two, or the lines of a
/// block would share the same few places of the cache.
template <class Value>
constexpr Index padded(Index n) {
    constexpr Index line = 64 / static_cast<Index>(sizeof(Value));
    return (n + line - 1) / line * line + line;
}

SpectrumBlock block_of(Index index, Index lines, Index modes, const Complex* values) {
    const Index first = index * lines_per_block;
    return {index, first, std::min(lines_per_block, lines - first), modes, padded<Complex>(modes), values};
}

bool are_zero(const Buffer<double>& line) {
    return std::all_of(line.begin(), line.end(), [](double value) { return value == 0.0; });
}

void require_shape(Index nx, Index ny) {
    if (nx < 1 || ny < 1)
        throw InvalidArgument(fmt::format("a transform of {} x {} points; expected at least 1 x 1", nx, ny));
}

}  // namespace

void transform_lines(const ArrayView2D& map, const std::function<void(Index, double*)>& prepare,
                     const BlockConsumer& consume, parallel::Threads threads) {
    const Index nx = map.rows(), ny = map.cols(), stride = padded<double>(nx);
    require_shape(nx, ny);
    const RealTransform transform(nx);
    parallel::for_each_index(extent(block_count(ny)), threads, [&](std::size_t index) {
        thread_local Buffer<double> lines;
        thread_local Buffer<Complex> spectra;
        const Index count = std::min(lines_per_block, ny - static_cast<Index>(index) * lines_per_block);
        lines.resize(extent(count * stride));
        spectra.resize(extent(count * padded<Complex>(transform.modes())));
        const auto block = block_of(static_cast<Index>(index), ny, transform.modes(), spectra.data());
        for (Index i = 0; i < nx; ++i) {
            const double* row = map.data() + i * map.outerStride() + block.first;
            for (Index j = 0; j < block.lines; ++j) lines[extent(j * stride + i)] = row[j];
        }
        for (Index j = 0; j < block.lines; ++j) {
            double* line = lines.data() + j * stride;
            prepare(block.first + j, line);
            transform.forward(line, spectra.data() + j * block.stride);
        }
        consume(block);
    });
}

void transform_map(Index nx, Index ny, const std::function<void(Index, double*)>& load, const BlockConsumer& consume,
                   parallel::Threads threads) {
    transform_padded_map(nx, ny, nx, load, consume, threads);
}

void transform_padded_map(Index nx, Index ny, Index rows, const std::function<void(Index, double*)>& load,
                          const BlockConsumer& consume, parallel::Threads threads) {
    require_shape(nx, ny);
    require_shape(rows, ny);
    const RealTransform along_y(ny);
    const ComplexTransform along_x(nx);
    const Index modes = along_y.modes();
    Buffer<Complex> half(extent(rows * modes));

    parallel::for_each_index(extent(block_count(rows)), threads, [&](std::size_t index) {
        thread_local Buffer<double> line;
        line.resize(extent(ny));
        const Index first = static_cast<Index>(index) * lines_per_block;
        for (Index i = first; i < std::min(rows, first + lines_per_block); ++i) {
            load(i, line.data());
            Complex* spectrum = half.data() + i * modes;
            if (are_zero(line)) std::fill_n(spectrum, modes, Complex{});  // a zero-padded map has many such lines
            else along_y.forward(line.data(), spectrum);
        }
    });
    parallel::for_each_index(extent(block_count(modes)), threads, [&](std::size_t index) {
        thread_local Buffer<Complex> lines;
        const Index count = std::min(lines_per_block, modes - static_cast<Index>(index) * lines_per_block);
        lines.resize(extent(count * padded<Complex>(nx)));
        const auto block = block_of(static_cast<Index>(index), modes, nx, lines.data());
        for (Index i = 0; i < rows; ++i) {
            const Complex* row = half.data() + i * modes + block.first;
            for (Index m = 0; m < block.lines; ++m) lines[extent(m * block.stride + i)] = row[m];
        }
        for (Index m = 0; m < block.lines; ++m)
            std::fill_n(lines.data() + m * block.stride + rows, nx - rows, Complex{});
        for (Index m = 0; m < block.lines; ++m) along_x.apply(lines.data() + m * block.stride);
        consume(block);
    });
}

}  // namespace setae::fourier
