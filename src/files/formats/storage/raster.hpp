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

/// Layout of the samples of a map or line in a source. A line has ny = 1.
struct Raster {
    std::uint64_t offset = 0;  ///< of the first sample
    Index nx = 0, ny = 0;
    Sample sample = Sample::float32;
    std::endian order = std::endian::little;
    bool columns = false;             ///< y is the fast index: columns stored one after the other
    bool bottom_up = false;           ///< the first row stored is the lowest
    bool right_to_left = false;       ///< the first value of a row is the rightmost
    std::uint64_t line_distance = 0;  ///< bytes between rows (between columns if `columns`); 0: no padding
    std::uint64_t step = 0;           ///< bytes between samples of a line; 0: contiguous

    [[nodiscard]] std::uint64_t sample_distance() const { return step ? step : bytes_of(sample); }
    [[nodiscard]] std::uint64_t row_distance() const {
        return line_distance ? line_distance : sample_distance() * static_cast<std::uint64_t>(columns ? ny : nx);
    }
};

/// height [m] = factor · raw + offset; raw values outside the limits become NaN, as do NaN and infinite ones.
struct RawScale {
    double factor = 1.0;
    double offset = 0.0;
    double least = -std::numeric_limits<double>::infinity();    ///< raw values below are undefined
    double greatest = std::numeric_limits<double>::infinity();  ///< raw values above are undefined
    std::vector<double> undefined = {};                         ///< raw values that are undefined
};

/// Refuses a raster that is not completely in its source, before memory of its size is allocated.
/// @throws FormatError "<format>: …" with the offset of the end of the file, for dimensions below 1 or beyond 2^31, or
/// overflow.
void require_raster(const Raster& raster, const bytes::Source& source, const std::string& format);

/// Heights h(x, y), y downwards, of a raster that require_raster accepted. Read in blocks on all cores: memory: the
/// heights and one block per thread.
[[nodiscard]] Array2D read_raster(const bytes::Source& source, const Raster& raster, const RawScale& scale);

/// A channel whose heights are read from a raster on request; an incomplete raster is refused immediately. `info` has
/// name, format, orientation, metadata and, if the file states them, size [m] and unit; `options` supplies missing
/// ones, and without them `read` throws InvalidArgument with the missing options. `scale` converts to metres, or to
/// `info.unit` if the user gives the unit.
/// @throws FormatError as require_raster, or for a size that is no positive length.
[[nodiscard]] Channel raster_channel(ChannelInfo info, const bytes::Source& source, const Raster& raster,
                                     const RawScale& scale, const ReadOptions& options = {});

}  // namespace setae::formats
