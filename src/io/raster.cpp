// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bytes.hpp"
#include "channel_building.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::io {
namespace {

constexpr Index most_points_a_direction = Index{1} << 31;
/// A block of lines is converted and turned in tiles of this many samples squared: both sides of the transposition stay in the cache.
constexpr Index tile = 64;
constexpr std::uint64_t block_bytes = 1 << 20;

[[noreturn]] void broken(const Source& source, const std::string& format, std::uint64_t offset, const std::string& what) {
    throw FormatError(source.name, {.offset = offset}, format + ": " + what);
}

/// How raw samples become heights, with what is seldom there told apart from what each sample goes through.
template <class Raw>
struct Conversion {
    explicit Conversion(const RawScale& scale) : scale_(scale) {}

    double operator()(const char* from, bool swapped) const {
        const auto raw = static_cast<double>(load<Raw>(from, swapped ? (std::endian::native == std::endian::little ? std::endian::big : std::endian::little) : std::endian::native));
        bool defined = raw >= scale_.least && raw <= scale_.greatest;
        for (const double value : scale_.undefined) defined = defined && raw != value;
        const double height = scale_.factor * raw + scale_.offset;
        return defined && std::isfinite(height) ? height : undefined;
    }

private:
    const RawScale& scale_;
};

/// Lines `first` to `last` of the file into their places.
template <class Raw, bool Swapped>
void convert_lines(const char* data, Index first, Index last, const Raster& raster, const RawScale& scale, Array2D& heights) {
    const Conversion<Raw> convert(scale);
    const auto distance = raster.row_distance(), step = raster.sample_distance();
    const Index samples = raster.columns ? raster.ny : raster.nx;
    const bool turn_lines = raster.columns ? raster.right_to_left : raster.bottom_up;
    const bool turn_samples = raster.columns ? raster.bottom_up : raster.right_to_left;
    const Index lines = raster.columns ? raster.nx : raster.ny;
    const auto place = [&](Index line, Index sample) -> double& {
        const Index l = turn_lines ? lines - 1 - line : line, s = turn_samples ? samples - 1 - sample : sample;
        return raster.columns ? heights(l, s) : heights(s, l);
    };
    const auto at = [&](Index line, Index sample) { return data + static_cast<std::uint64_t>(line - first) * distance + static_cast<std::uint64_t>(sample) * step; };
    if (raster.columns) {
        for (Index line = first; line < last; ++line)
            for (Index sample = 0; sample < samples; ++sample) place(line, sample) = convert(at(line, sample), Swapped);
        return;
    }
    for (Index left = 0; left < samples; left += tile)
        for (Index sample = left; sample < std::min(left + tile, samples); ++sample)
            for (Index line = first; line < last; ++line) place(line, sample) = convert(at(line, sample), Swapped);
}

template <class Raw>
void convert_lines(const char* data, Index first, Index last, const Raster& raster, const RawScale& scale, Array2D& heights) {
    if (raster.order == std::endian::native)
        convert_lines<Raw, false>(data, first, last, raster, scale, heights);
    else
        convert_lines<Raw, true>(data, first, last, raster, scale, heights);
}

void convert_lines(const char* data, Index first, Index last, const Raster& raster, const RawScale& scale, Array2D& heights) {
    const auto with = [&]<class Raw>(Raw) { convert_lines<Raw>(data, first, last, raster, scale, heights); };
    switch (raster.sample) {
        case Sample::int8: return with(std::int8_t{});
        case Sample::uint8: return with(std::uint8_t{});
        case Sample::int16: return with(std::int16_t{});
        case Sample::uint16: return with(std::uint16_t{});
        case Sample::int32: return with(std::int32_t{});
        case Sample::uint32: return with(std::uint32_t{});
        case Sample::int64: return with(std::int64_t{});
        case Sample::uint64: return with(std::uint64_t{});
        case Sample::float32: return with(float{});
        case Sample::float64: return with(double{});
    }
}

/// Bytes from a line's first sample to the end of its last.
std::uint64_t line_bytes(const Raster& raster) {
    const auto samples = static_cast<std::uint64_t>(raster.columns ? raster.ny : raster.nx);
    return (samples - 1) * raster.sample_distance() + bytes_of(raster.sample);
}

topography::Measurement measured(const Source& source, const Raster& raster, const RawScale& scale, bool line, const std::vector<double>& size, const topography::Metadata& metadata) {
    auto heights = read_raster(source, raster, scale);
    if (line) return checked(topography::LineScan{Eigen::Map<const Array1D>(heights.data(), heights.size()), size[0], false, metadata}, source);
    return checked(topography::HeightMap{std::move(heights), {size[0], size[1]}, false, metadata}, source);
}

}  // namespace

std::uint64_t bytes_of(Sample sample) {
    switch (sample) {
        case Sample::int8:
        case Sample::uint8: return 1;
        case Sample::int16:
        case Sample::uint16: return 2;
        case Sample::int32:
        case Sample::uint32:
        case Sample::float32: return 4;
        default: return 8;
    }
}

void require_raster(const Raster& raster, const Source& source, const std::string& format) {
    if (raster.nx < 1 || raster.ny < 1 || raster.nx > most_points_a_direction || raster.ny > most_points_a_direction)
        broken(source, format, std::min(raster.offset, source.size), fmt::format("{} × {} points, expected 1 to 2^31 along each direction", raster.nx, raster.ny));
    const auto lines = static_cast<std::uint64_t>(raster.columns ? raster.nx : raster.ny);
    const auto samples = static_cast<std::uint64_t>(raster.columns ? raster.ny : raster.nx);
    if (samples > source.size / raster.sample_distance() + 1 || lines > source.size / std::max<std::uint64_t>(raster.row_distance(), 1) + 1)
        broken(source, format, source.size, fmt::format("the file ends here, it announces {} × {} points of {} bytes; it is truncated or damaged", raster.nx, raster.ny, bytes_of(raster.sample)));
    const auto needed = (lines - 1) * raster.row_distance() + line_bytes(raster);
    if (raster.offset > source.size || needed > source.size - raster.offset)
        broken(source, format, source.size, fmt::format("the file ends here, its heights ({} × {} points) should end at byte {}; it is truncated", raster.nx, raster.ny, raster.offset + needed));
}

Array2D read_raster(const Source& source, const Raster& raster, const RawScale& scale) {
    const Index lines = raster.columns ? raster.nx : raster.ny;
    const auto distance = raster.row_distance();
    const auto wanted = static_cast<Index>(block_bytes / std::max<std::uint64_t>(distance, 1));
    const Index together = std::clamp<Index>(wanted / tile * tile, raster.columns ? 1 : std::min<Index>(tile, lines), lines);
    const auto blocks = static_cast<std::size_t>((lines + together - 1) / together);
    Array2D heights(raster.nx, raster.ny);
    parallel::for_each_index(blocks, {}, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * together, last = std::min(first + together, lines);
        const auto data = source.bytes(raster.offset + static_cast<std::uint64_t>(first) * distance,
                                       static_cast<std::uint64_t>(last - first - 1) * distance + line_bytes(raster));
        convert_lines(data.data(), first, last, raster, scale, heights);
    });
    return heights;
}

Channel raster_channel(ChannelInfo info, const Source& source, const Raster& raster, const RawScale& scale, const ReadOptions& options) {
    require_raster(raster, source, info.format);
    const bool line = raster.ny == 1;
    info.shape = line ? std::vector<Index>{raster.nx} : std::vector<Index>{raster.nx, raster.ny};
    info.size.resize(std::min(info.size.size(), info.shape.size()));
    const double given = complete(info, options, source);
    if (info.size.empty() || info.unit.empty()) return incomplete_channel(std::move(info), source);
    auto metres = scale;
    metres.factor *= given;
    metres.offset *= given;
    auto read = [source, raster, metres, line, size = info.size, metadata = info.metadata] { return measured(source, raster, metres, line, size, metadata); };
    return {std::move(info), std::move(read)};
}

}  // namespace setae::io
