// SPDX-License-Identifier: GPL-3.0-or-later
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "setae/bytes/expand.hpp"
#include "setae/core/errors.hpp"
#include "tiff_file.hpp"

namespace setae::formats {
namespace {

constexpr std::uint64_t most_pieces = 1 << 22;
constexpr std::uint64_t allocation_floor = 1 << 24;  ///< what libtiff may take at once for the smallest file

/// What is needed to find and expand a page's pixels.
struct Layout {
    std::uint64_t page_offset = 0;
    Index nx = 0, ny = 0;
    Sample sample = Sample::uint8;
    std::uint64_t compression = 1;
    bool tiled = false;
    std::uint64_t piece_nx = 0, piece_ny = 0;  ///< of a strip or tile
    std::vector<std::uint64_t> offsets, byte_counts;

    [[nodiscard]] std::uint64_t row_bytes() const { return static_cast<std::uint64_t>(nx) * bytes_of(sample); }
    [[nodiscard]] std::uint64_t pixel_bytes() const { return row_bytes() * static_cast<std::uint64_t>(ny); }
    [[nodiscard]] std::uint64_t across() const { return (static_cast<std::uint64_t>(nx) + piece_nx - 1) / piece_nx; }
    [[nodiscard]] std::uint64_t down() const { return (static_cast<std::uint64_t>(ny) + piece_ny - 1) / piece_ny; }
};

[[noreturn]] void broken(const TiffFile& file, std::uint64_t offset, const std::string& what) {
    throw FormatError(file.source.name, {.offset = offset}, fmt::format("{}: {}", file.format, what));
}

std::uint64_t entry(const TiffFile& file, const TiffPage& page, std::uint16_t id, std::uint64_t fallback) {
    const auto values = file.integers(page, id, most_pieces);
    return values.empty() ? fallback : values.front();
}

Sample sample_of(const TiffFile& file, const TiffPage& page) {
    const auto bits = entry(file, page, TIFFTAG_BITSPERSAMPLE, 1),
               kind = entry(file, page, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT),
               samples = entry(file, page, TIFFTAG_SAMPLESPERPIXEL, 1);
    if (samples != 1) broken(file, page.offset, fmt::format("{} samples a pixel, expected one", samples));
    switch (1000 * kind + bits) {
        case 1000 * SAMPLEFORMAT_UINT + 8: return Sample::uint8;
        case 1000 * SAMPLEFORMAT_UINT + 16: return Sample::uint16;
        case 1000 * SAMPLEFORMAT_UINT + 32: return Sample::uint32;
        case 1000 * SAMPLEFORMAT_INT + 8: return Sample::int8;
        case 1000 * SAMPLEFORMAT_INT + 16: return Sample::int16;
        case 1000 * SAMPLEFORMAT_INT + 32: return Sample::int32;
        case 1000 * SAMPLEFORMAT_IEEEFP + 32: return Sample::float32;
        case 1000 * SAMPLEFORMAT_IEEEFP + 64: return Sample::float64;
        default:
            broken(
                file, page.offset,
                fmt::format(
                    "pixels of {} bits in sample format {}, expected integers of 8, 16 or 32 bits or floats of 32 or 64",
                    bits, kind));
    }
}

Layout layout_of(const TiffFile& file, const TiffPage& page) {
    Layout layout{.page_offset = page.offset, .sample = sample_of(file, page)};
    const auto width = entry(file, page, TIFFTAG_IMAGEWIDTH, 0), height = entry(file, page, TIFFTAG_IMAGELENGTH, 0);
    if (width == 0 || height == 0 || width > (1u << 30) || height > (1u << 30))
        broken(file, page.offset, fmt::format("a page of {} × {} pixels", width, height));
    layout.nx = static_cast<Index>(width);
    layout.ny = static_cast<Index>(height);
    layout.compression = entry(file, page, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    layout.tiled = page.find(TIFFTAG_TILEWIDTH) != nullptr;
    layout.piece_nx = layout.tiled ? entry(file, page, TIFFTAG_TILEWIDTH, 0) : width;
    layout.piece_ny = layout.tiled ? entry(file, page, TIFFTAG_TILELENGTH, 0)
                                   : std::min(entry(file, page, TIFFTAG_ROWSPERSTRIP, height), height);
    layout.offsets = file.integers(page, layout.tiled ? TIFFTAG_TILEOFFSETS : TIFFTAG_STRIPOFFSETS, most_pieces);
    layout.byte_counts =
        file.integers(page, layout.tiled ? TIFFTAG_TILEBYTECOUNTS : TIFFTAG_STRIPBYTECOUNTS, most_pieces);
    if (layout.piece_nx == 0 || layout.piece_ny == 0 || layout.piece_nx > (1u << 30) || layout.piece_ny > (1u << 30))
        broken(file, page.offset, fmt::format("pieces of {} × {} pixels", layout.piece_nx, layout.piece_ny));
    return layout;
}

/// Refuses pieces that are not in the file, are too few, or announce to become more than honest ones do.
void require_pieces(const TiffFile& file, const Layout& layout) {
    const auto needed = layout.across() * layout.down();
    if (layout.offsets.size() < needed || layout.byte_counts.size() < needed)
        broken(file, layout.page_offset,
               fmt::format("{} of the {} strips or tiles of {} × {} pixels are there",
                           std::min(layout.offsets.size(), layout.byte_counts.size()), needed, layout.nx, layout.ny));
    std::uint64_t stored = 0;
    for (std::size_t k = 0; k < needed; ++k) {
        if (layout.offsets[k] > file.source.size || layout.byte_counts[k] > file.source.size - layout.offsets[k])
            broken(file, file.source.size,
                   fmt::format("the file ends here, a strip or tile should end at byte {}; it is truncated",
                               layout.offsets[k] + layout.byte_counts[k]));
        stored += layout.byte_counts[k];
    }
    stored = std::min(stored, file.source.size);
    // pixels become heights of 8 bytes: those of one byte are counted as two
    const auto width = std::max<std::uint64_t>(bytes_of(layout.sample), 2);
    const auto announced =
        width * std::max(static_cast<std::uint64_t>(layout.nx) * static_cast<std::uint64_t>(layout.ny),
                         layout.piece_nx * layout.piece_ny);
    if (announced > bytes::most_expanded(stored))
        broken(file, layout.page_offset,
               fmt::format("{} bytes of strips or tiles announce {} × {} pixels; it is damaged", stored, layout.nx,
                           layout.ny));
}

/// Whether rows lie in the file as they are, one behind the other.
bool side_by_side(const Layout& layout) {
    if (layout.compression != COMPRESSION_NONE || layout.tiled) return false;
    std::uint64_t left = layout.pixel_bytes();
    for (std::size_t k = 0; k < layout.down(); ++k) {
        const auto bytes = std::min(left, layout.row_bytes() * layout.piece_ny);
        if (layout.byte_counts[k] < bytes ||
            (k > 0 && layout.offsets[k] != layout.offsets[k - 1] + layout.row_bytes() * layout.piece_ny))
            return false;
        left -= bytes;
    }
    return true;
}

/// A file as libtiff sees it, and what it complains of. No exception crosses libtiff.
struct Stream {
    bytes::Source source;
    std::uint64_t position = 0;
    std::string complaint = {};
};

tmsize_t read_stream(thandle_t handle, void* target, tmsize_t count) {
    auto& stream = *static_cast<Stream*>(handle);
    if (count < 0 || stream.position > stream.source.size) return 0;
    const auto bytes = std::min(static_cast<std::uint64_t>(count), stream.source.size - stream.position);
    try {
        stream.source.read_into(stream.position, bytes, static_cast<char*>(target));
    } catch (const std::exception& error) {
        stream.complaint = error.what();
        return 0;
    }
    stream.position += bytes;
    return static_cast<tmsize_t>(bytes);
}

tmsize_t refuse_writing(thandle_t, void*, tmsize_t) { return 0; }

toff_t seek_stream(thandle_t handle, toff_t offset, int whence) {
    auto& stream = *static_cast<Stream*>(handle);
    stream.position = offset + (whence == SEEK_CUR ? stream.position : whence == SEEK_END ? stream.source.size : 0);
    return stream.position;
}

int close_stream(thandle_t) { return 0; }
toff_t size_of_stream(thandle_t handle) { return static_cast<Stream*>(handle)->source.size; }

int keep_complaint(TIFF*, void* user, const char*, const char* text, va_list arguments) {
    auto& stream = *static_cast<Stream*>(user);
    if (!stream.complaint.empty()) return 1;
    char message[256];
    std::vsnprintf(message, sizeof message, text, arguments);
    stream.complaint = message;
    return 1;
}

int ignore_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

std::unique_ptr<TIFF, CloseTiff> opened(Stream& stream) {
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                   &TIFFOpenOptionsFree);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(),
                                        static_cast<tmsize_t>(2 * stream.source.size + allocation_floor));
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_complaint, &stream);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_warning, &stream);
    // r: read, m: not mapped, h: no directory before one is asked for
    return std::unique_ptr<TIFF, CloseTiff>(TIFFClientOpenExt("pixels", "rmh", &stream, read_stream, refuse_writing,
                                                              seek_stream, close_stream, size_of_stream, nullptr,
                                                              nullptr, options.get()));
}

/// Rows and columns of a tile that lie within the picture, to their place.
void place_tile(const std::string& tile, const Layout& layout, std::uint64_t number, std::string& pixels) {
    const auto bytes = bytes_of(layout.sample), tile_row = layout.piece_nx * bytes;
    const auto left = number % layout.across() * tile_row, top = number / layout.across() * layout.piece_ny;
    const auto width = std::min(tile_row, layout.row_bytes() - left),
               height = std::min(layout.piece_ny, static_cast<std::uint64_t>(layout.ny) - top);
    for (std::uint64_t row = 0; row < height; ++row)
        std::memcpy(pixels.data() + (top + row) * layout.row_bytes() + left, tile.data() + row * tile_row, width);
}

/// All rows of the page, in the byte order of this machine.
std::string expanded(const TiffFile& file, const Layout& layout) {
    Stream stream{file.source};
    const auto tiff = opened(stream);
    const auto failed = [&](std::uint64_t offset) {
        broken(file, offset,
               fmt::format("pixels cannot be expanded: {}",
                           stream.complaint.empty() ? "they are damaged" : stream.complaint));
    };
    if (!tiff || !TIFFSetSubDirectory(tiff.get(), layout.page_offset)) failed(layout.page_offset);
    std::string pixels(layout.pixel_bytes(), '\0');
    std::string tile(layout.tiled ? layout.piece_nx * layout.piece_ny * bytes_of(layout.sample) : 0, '\0');
    const bool same = layout.tiled ? TIFFTileSize64(tiff.get()) == tile.size()
                                   : TIFFStripSize64(tiff.get()) == layout.row_bytes() * layout.piece_ny;
    if (!same) failed(layout.page_offset);
    for (std::uint64_t k = 0; k < layout.across() * layout.down(); ++k) {
        const auto number = static_cast<std::uint32_t>(k);
        const auto at = layout.tiled ? 0 : k * layout.row_bytes() * layout.piece_ny;
        const auto wanted = static_cast<tmsize_t>(
            layout.tiled ? tile.size() : std::min(layout.row_bytes() * layout.piece_ny, pixels.size() - at));
        const auto got = layout.tiled ? TIFFReadEncodedTile(tiff.get(), number, tile.data(), wanted)
                                      : TIFFReadEncodedStrip(tiff.get(), number, pixels.data() + at, wanted);
        if (got != wanted) failed(layout.offsets[k]);
        if (layout.tiled) place_tile(tile, layout, k, pixels);
    }
    return pixels;
}

/// Pixels expanded once, by the first thread that asks.
bytes::Source expanded_source(const TiffFile& file, Layout layout) {
    struct State {
        std::mutex mutex;
        std::optional<std::string> pixels;
    };
    bytes::Source source{.name = file.source.name, .size = layout.pixel_bytes(), .path = {}, .read_into = {}};
    // what reads pixels keeps no directories: a file may have many pages
    source.read_into = [file = TiffFile{.source = file.source, .format = file.format, .order = file.order, .pages = {}},
                        layout = std::move(layout),
                        state = std::make_shared<State>()](std::uint64_t offset, std::uint64_t count, char* target) {
        const std::lock_guard lock(state->mutex);
        if (!state->pixels) state->pixels = expanded(file, layout);
        std::memcpy(target, state->pixels->data() + offset, count);
    };
    return source;
}

}  // namespace

TiffPixels tiff_pixels(const TiffFile& file, const TiffPage& page) {
    auto layout = layout_of(file, page);
    require_pieces(file, layout);
    Raster raster{.nx = layout.nx, .ny = layout.ny, .sample = layout.sample};
    if (side_by_side(layout)) {
        raster.offset = layout.offsets.front();
        raster.order = file.order;
        return {file.source, raster};
    }
    raster.order = std::endian::native;
    return {expanded_source(file, std::move(layout)), raster};
}

}  // namespace setae::formats
