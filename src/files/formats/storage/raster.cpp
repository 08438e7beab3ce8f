// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster.hpp"

#ifdef __linux__
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/platform/memory.hpp"

namespace setae::formats {
namespace {

constexpr Index max_points_per_direction = Index{1} << 31;
/// Lines and samples that are converted and transposed together: they fit into the first-level cache, with 512
/// contiguous bytes of each row of heights.
constexpr Index tile_lines = 64, tile_samples = 32;
/// Bytes read together by a thread; less of each line if lines are long.
constexpr std::uint64_t block_bytes = std::uint64_t{4} << 20;

[[noreturn]] void broken(const bytes::Source& source, const std::string& format, std::uint64_t offset,
                         const std::string& what) {
    throw FormatError(source.name, {.offset = offset}, format + ": " + what);
}

template <std::size_t bytes>
auto swapped(const char* from) {
    if constexpr (bytes == 2) {
        std::uint16_t value;
        std::memcpy(&value, from, bytes);
        return __builtin_bswap16(value);
    } else if constexpr (bytes == 4) {
        std::uint32_t value;
        std::memcpy(&value, from, bytes);
        return __builtin_bswap32(value);
    } else {
        std::uint64_t value;
        std::memcpy(&value, from, bytes);
        return __builtin_bswap64(value);
    }
}

template <class Raw, bool Swapped>
Raw sample_at(const char* from) {
    if constexpr (Swapped && sizeof(Raw) > 1) {
        return std::bit_cast<Raw>(swapped<sizeof(Raw)>(from));
    } else {
        Raw value;
        std::memcpy(&value, from, sizeof(Raw));
        return value;
    }
}

/// Raw samples of a line, contiguous or `step` bytes apart.
template <class Raw, bool Swapped>
void take_samples(const char* from, std::uint64_t step, Index count, double* values) {
    const auto n = static_cast<std::size_t>(count);
    if (step == sizeof(Raw))
        for (std::size_t i = 0; i < n; ++i)
            values[i] = static_cast<double>(sample_at<Raw, Swapped>(from + i * sizeof(Raw)));
    else
        for (std::size_t i = 0; i < n; ++i) values[i] = static_cast<double>(sample_at<Raw, Swapped>(from + i * step));
}

using TakeSamples = void (*)(const char*, std::uint64_t, Index, double*);

TakeSamples samples_taker(Sample sample, std::endian order) {
    const auto of = [&]<class Raw>(Raw) -> TakeSamples {
        return order == std::endian::native ? take_samples<Raw, false> : take_samples<Raw, true>;
    };
    switch (sample) {
        case Sample::int8: return of(std::int8_t{});
        case Sample::uint8: return of(std::uint8_t{});
        case Sample::int16: return of(std::int16_t{});
        case Sample::uint16: return of(std::uint16_t{});
        case Sample::int32: return of(std::int32_t{});
        case Sample::uint32: return of(std::uint32_t{});
        case Sample::int64: return of(std::int64_t{});
        case Sample::uint64: return of(std::uint64_t{});
        case Sample::float32: return of(float{});
        default: return of(double{});
    }
}

/// Converts raw values to heights in place, without a branch: h − (h − h) is h if it is finite and NaN otherwise.
void make_heights(double* values, Index count, const RawScale& scale) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double factor = scale.factor, offset = scale.offset, least = scale.least, greatest = scale.greatest;
    if (scale.undefined.empty() && least == -infinity && greatest == infinity) {
        for (Index i = 0; i < count; ++i) {
            const double height = factor * values[i] + offset;
            values[i] = height - (height - height);
        }
        return;
    }
    for (Index i = 0; i < count; ++i) {
        const double raw = values[i], height = factor * raw + offset;
        bool defined = raw >= least && raw <= greatest;
        for (const double value : scale.undefined) defined = defined && raw != value;
        values[i] = defined ? height - (height - height) : undefined;
    }
}

/// Lines and samples that are read and converted together.
struct RasterBlock {
    Index first_line = 0, lines = 0, first_sample = 0, samples = 0;
};

/// Division of a raster into blocks.
struct Blocks {
    explicit Blocks(const Raster& raster)
        : lines(raster.columns ? raster.nx : raster.ny), samples(raster.columns ? raster.ny : raster.nx) {
        const auto tile = static_cast<std::uint64_t>(raster.columns ? 1 : tile_lines),
                   distance = std::max<std::uint64_t>(raster.row_distance(), 1);
        const auto whole_lines = static_cast<Index>(block_bytes / distance) / tile_lines * tile_lines;
        lines_together = std::clamp<Index>(whole_lines, raster.columns ? 1 : std::min(tile_lines, lines), lines);
        const auto fitting = static_cast<Index>(block_bytes / tile / raster.sample_distance());
        samples_together = distance * tile <= block_bytes ? samples : std::clamp<Index>(fitting, 1, samples);
        across = (samples + samples_together - 1) / samples_together;
        count = static_cast<std::size_t>(across * ((lines + lines_together - 1) / lines_together));
    }

    [[nodiscard]] RasterBlock operator[](std::size_t number) const {
        const Index line = static_cast<Index>(number) / across * lines_together,
                    sample = static_cast<Index>(number) % across * samples_together;
        return {line, std::min(lines_together, lines - line), sample, std::min(samples_together, samples - sample)};
    }

    Index lines, samples, lines_together = 1, samples_together = 1, across = 1;
    std::size_t count = 1;
};

/// Reads the bytes of a block: lines in one call unless the gaps between them are large.
struct BlockReader {
    const bytes::Source& source;
    const Raster& raster;
    std::unique_ptr<char[]> memory = {};
    std::uint64_t capacity = 0;

    /// Returns the distance of the lines of the block in `memory`.
    std::uint64_t read(const RasterBlock& block) {
        const auto step = raster.sample_distance(), distance = raster.row_distance();
        const auto part = (static_cast<std::uint64_t>(block.samples) - 1) * step + bytes_of(raster.sample);
        const auto lines = static_cast<std::uint64_t>(block.lines);
        const bool all_samples = block.samples == (raster.columns ? raster.ny : raster.nx);
        const bool whole = lines == 1 || (all_samples && (lines - 1) * distance + part <= 2 * block_bytes);
        const auto apart = whole ? distance : part;
        const auto needed = (lines - 1) * apart + part;
        if (needed > capacity) memory.reset(new char[needed]);  // not initialised
        capacity = std::max(capacity, needed);
        const auto begin = raster.offset + static_cast<std::uint64_t>(block.first_line) * distance +
                           static_cast<std::uint64_t>(block.first_sample) * step;
        if (whole) source.read_into(begin, needed, memory.get());
        else
            for (std::uint64_t line = 0; line < lines; ++line)
                source.read_into(begin + line * distance, part, memory.get() + line * apart);
        return apart;
    }
};

/// A block whose lines run along y, like the rows of heights.
void place_columns(const char* data, std::uint64_t distance, const RasterBlock& block, const Raster& raster,
                   const RawScale& scale, TakeSamples take, Array2D& heights) {
    const Index first_y = raster.bottom_up ? raster.ny - block.first_sample - block.samples : block.first_sample;
    for (Index line = 0; line < block.lines; ++line) {
        const Index from_left = block.first_line + line,
                    x = raster.right_to_left ? raster.nx - 1 - from_left : from_left;
        double* const row = heights.data() + x * raster.ny + first_y;
        take(data + static_cast<std::uint64_t>(line) * distance, raster.sample_distance(), block.samples, row);
        make_heights(row, block.samples, scale);
        if (raster.bottom_up) std::reverse(row, row + block.samples);
    }
}

/// A block whose lines run along x: transposed tile by tile.
void place_rows(const char* data, std::uint64_t distance, const RasterBlock& block, const Raster& raster,
                const RawScale& scale, TakeSamples take, Array2D& heights) {
    alignas(64) std::array<double, tile_lines * tile_samples> tile;
    for (Index top = 0; top < block.lines; top += tile_lines) {
        const Index lines = std::min(tile_lines, block.lines - top), first = block.first_line + top;
        const Index first_y = raster.bottom_up ? raster.ny - first - lines : first;
        for (Index left = 0; left < block.samples; left += tile_samples) {
            const Index samples = std::min(tile_samples, block.samples - left);
            for (Index line = 0; line < lines; ++line) {
                double* const values = tile.data() + (raster.bottom_up ? lines - 1 - line : line) * tile_samples;
                take(data + static_cast<std::uint64_t>(top + line) * distance +
                         static_cast<std::uint64_t>(left) * raster.sample_distance(),
                     raster.sample_distance(), samples, values);
                make_heights(values, samples, scale);
            }
            for (Index sample = 0; sample < samples; ++sample) {
                const Index from_left = block.first_sample + left + sample,
                            x = raster.right_to_left ? raster.nx - 1 - from_left : from_left;
                double* const row = heights.data() + x * raster.ny + first_y;
                for (Index line = 0; line < lines; ++line)
                    row[line] = tile[static_cast<std::size_t>(line * tile_samples + sample)];
            }
        }
    }
}

/// Bytes from the first sample of a line to the end of its last.
std::uint64_t line_bytes(const Raster& raster) {
    const auto samples = static_cast<std::uint64_t>(raster.columns ? raster.ny : raster.nx);
    return (samples - 1) * raster.sample_distance() + bytes_of(raster.sample);
}

/// The part of a raster that holds some lines of heights, y = first … first + count − 1.
Raster lines_of(const Raster& raster, Index first, Index count) {
    Raster part = raster;
    const auto from_top = static_cast<std::uint64_t>(raster.bottom_up ? raster.ny - first - count : first);
    part.ny = count;
    part.line_distance = raster.row_distance();
    part.offset += from_top * (raster.columns ? raster.sample_distance() : part.line_distance);
    return part;
}

topography::Measurement measured(const bytes::Source& source, const Raster& raster, const RawScale& scale, bool line,
                                 const std::vector<double>& size, const topography::Metadata& metadata) {
    auto heights = read_raster(source, raster, scale);
    topography::Measurement measurement = topography::LineScan{};
    if (line)
        measurement =
            topography::LineScan{Eigen::Map<const Array1D>(heights.data(), heights.size()), size[0], false, metadata};
    else measurement = topography::HeightMap{std::move(heights), {size[0], size[1]}, false, metadata};
    require_measurement(measurement, source);
    return measurement;
}

/// Raw values for missing heights of integers: the extremes of the type; for unsigned types only the largest, because 0
/// is a valid height.
std::vector<double> extremes_of(Sample sample) {
    switch (sample) {
        case Sample::int16: return {-0x1p15, 0x1p15 - 1.0};
        case Sample::int32: return {-0x1p31, 0x1p31 - 1.0};
        case Sample::uint16: return {0x1p16 - 1.0};
        case Sample::uint32: return {0x1p32 - 1.0};
        default: return {};
    }
}

}  // namespace

double loaded(const char* from, Sample sample, std::endian order) {
    double value = 0.0;
    samples_taker(sample, order)(from, bytes_of(sample), 1, &value);
    return value;
}

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

void require_raster(const Raster& raster, const bytes::Source& source, const std::string& format) {
    if (raster.nx < 1 || raster.ny < 1 || raster.nx > max_points_per_direction || raster.ny > max_points_per_direction)
        broken(source, format, std::min(raster.offset, source.size),
               fmt::format("{} × {} points, expected 1 to 2^31 along each direction", raster.nx, raster.ny));
    const auto lines = static_cast<std::uint64_t>(raster.columns ? raster.nx : raster.ny);
    const auto samples = static_cast<std::uint64_t>(raster.columns ? raster.ny : raster.nx);
    if (samples > source.size / raster.sample_distance() + 1 ||
        lines > source.size / std::max<std::uint64_t>(raster.row_distance(), 1) + 1)
        broken(
            source, format, source.size,
            fmt::format("the file ends here, but it announces {} × {} points of {} bytes; it is truncated or damaged",
                        raster.nx, raster.ny, bytes_of(raster.sample)));
    const auto needed = (lines - 1) * raster.row_distance() + line_bytes(raster);
    if (raster.offset > source.size || needed > source.size - raster.offset)
        broken(source, format, source.size,
               fmt::format("the file ends here, expected the end of its heights ({} × {} points) at byte {}; it is "
                           "truncated",
                           raster.nx, raster.ny, raster.offset + needed));
}

Array2D read_raster(const bytes::Source& source, const Raster& raster, const RawScale& scale) {
    const Blocks blocks(raster);
    const auto take = samples_taker(raster.sample, raster.order);
    Array2D heights(raster.nx, raster.ny);
    platform::prefer_large_pages(heights.data(), static_cast<std::uint64_t>(heights.size()) * sizeof(double));
    std::atomic<std::size_t> next{0};
    const auto workers = std::min(blocks.count, static_cast<std::size_t>(parallel::Threads{}.resolved()));
    parallel::for_each_index(workers, {}, [&](std::size_t) {
        BlockReader reader{source, raster};
        for (auto number = next.fetch_add(1); number < blocks.count; number = next.fetch_add(1)) {
            const auto block = blocks[number];
            const auto distance = reader.read(block);
            (raster.columns ? place_columns : place_rows)(reader.memory.get(), distance, block, raster, scale, take,
                                                          heights);
        }
    });
    return heights;
}

Channel raster_channel(ChannelInfo info, const bytes::Source& source, const Raster& raster, const RawScale& scale,
                       const ReadOptions& options) {
    require_raster(raster, source, info.format);
    const bool line = raster.ny == 1;
    info.shape = line ? std::vector<Index>{raster.nx} : std::vector<Index>{raster.nx, raster.ny};
    info.size.resize(std::min(info.size.size(), info.shape.size()));
    const double given = complete(info, options, source);
    if (info.size.empty() || info.unit.empty()) return incomplete_channel(std::move(info), source);
    auto metres = scale;
    metres.factor *= given;
    metres.offset *= given;
    auto read = [source, raster, metres, line, size = info.size, metadata = info.metadata] {
        return measured(source, raster, metres, line, size, metadata);
    };
    auto codes = extremes_of(raster.sample);
    for (double& code : codes) code = metres.factor * code + metres.offset;
    if (line) return {.info = std::move(info), .read = std::move(read), .no_data_codes = std::move(codes)};
    auto lines = [source, raster, metres](Index first, Index count) {
        if (first < 0 || count < 1 || count > raster.ny - first)
            throw InvalidArgument(fmt::format("{}: lines {} to {} were requested, but the map has lines 0 to {}",
                                              source.name, first, first + count - 1, raster.ny - 1));
        return read_raster(source, lines_of(raster, first, count), metres);
    };
    return {
        .info = std::move(info), .read = std::move(read), .lines = std::move(lines), .no_data_codes = std::move(codes)};
}

}  // namespace setae::formats
