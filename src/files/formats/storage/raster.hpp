// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/arrays.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

enum class Sample { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

[[nodiscard]] std::uint64_t bytes_of(Sample sample);
/// One stored value.
[[nodiscard]] double loaded(const char* from, Sample sample, std::endian order);

/// Where the samples of a map or line lie in a source, and how. A line has ny = 1.
struct Raster {
    std::uint64_t offset = 0;  ///< of the first sample
    Index nx = 0, ny = 0;
    Sample sample = Sample::float32;
    std::endian order = std::endian::little;
    bool columns = false;             ///< y is the fast index: columns stored one after the other
    bool bottom_up = false;           ///< the first row stored is the lowest
    bool right_to_left = false;       ///< the first value of a row is the rightmost
    std::uint64_t line_distance = 0;  ///< bytes from row to row (column to column where `columns`); 0: no padding
    std::uint64_t step = 0;           ///< bytes from sample to sample within a line; 0: side by side

    [[nodiscard]] std::uint64_t sample_distance() const { return step ? step : bytes_of(sample); }
    [[nodiscard]] std::uint64_t row_distance() const {
        return line_distance ? line_distance : sample_distance() * static_cast<std::uint64_t>(columns ? ny : nx);
    }
};

/// height [m] = factor · raw + offset; raw values that are no heights become NaN, as NaN and infinite ones do.
struct RawScale {
    double factor = 1.0;
    double offset = 0.0;
    double least = -std::numeric_limits<double>::infinity();    ///< raw values below are undefined
    double greatest = std::numeric_limits<double>::infinity();  ///< raw values above are undefined
    std::vector<double> undefined = {};                         ///< raw values that are undefined
};

/// Refuses a raster that is not wholly in its source, before anything of its size is allocated.
/// @throws FormatError "<format>: …" with the offset where the file ends, for dimensions below 1 or beyond 2^31, or
/// overflow.
void require_raster(const Raster& raster, const bytes::Source& source, const std::string& format);

/// Heights h(x, y), y downwards, of a raster that require_raster accepted. Read in blocks on all cores: memory is the
/// heights and a block a thread.
[[nodiscard]] Array2D read_raster(const bytes::Source& source, const Raster& raster, const RawScale& scale);

/// A channel whose heights are read from a raster when asked; refuses now what is not wholly there. `info` has name,
/// format, orientation, metadata and, where the file states them, size [m] and unit; what it leaves open comes from
/// `options`, and without them `read` throws InvalidArgument that tells what to give. `scale` is to metres, or to
/// `info.unit` where the user gives the unit.
/// @throws FormatError as require_raster, or for a size that is no positive length.
[[nodiscard]] Channel raster_channel(ChannelInfo info, const bytes::Source& source, const Raster& raster,
                                     const RawScale& scale, const ReadOptions& options = {});

}  // namespace setae::formats
