// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/tiff_decoder.hpp"

#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

/// A file for libtiff, and its messages. No exception passes through libtiff.
struct Stream {
    Source source;
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

/// A page that libtiff has open.
class Page {
public:
    Page(const Source& source, const std::string& format, const TiffPieces& pieces, std::uint64_t max_memory)
        : stream_{source}, format_(format), pieces_(pieces) {
        const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                       &TIFFOpenOptionsFree);
        TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), static_cast<tmsize_t>(max_memory));
        TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_complaint, &stream_);
        TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_warning, &stream_);
        // r: read, m: not mapped, h: no directory before one is requested
        tiff_.reset(TIFFClientOpenExt("pixels", "rmh", &stream_, read_stream, refuse_writing, seek_stream, close_stream,
                                      size_of_stream, nullptr, nullptr, options.get()));
        if (!tiff_ || !TIFFSetSubDirectory(tiff_.get(), pieces_.directory)) fail(pieces_.directory);
    }

    [[nodiscard]] std::string rows() {
        std::string pixels(pieces_.bytes(), '\0');
        const auto strip_bytes = pieces_.row_bytes() * pieces_.piece_ny;
        std::string tile(pieces_.tiled ? pieces_.piece_nx * pieces_.piece_ny * pieces_.pixel_bytes : 0, '\0');
        const bool same =
            pieces_.tiled ? TIFFTileSize64(tiff_.get()) == tile.size() : TIFFStripSize64(tiff_.get()) == strip_bytes;
        if (!same) fail(pieces_.directory);
        for (std::uint64_t k = 0; k < pieces_.across() * pieces_.down(); ++k) {
            const auto number = static_cast<std::uint32_t>(k);
            const auto at = pieces_.tiled ? 0 : k * strip_bytes;
            const auto wanted =
                static_cast<tmsize_t>(pieces_.tiled ? tile.size() : std::min(strip_bytes, pixels.size() - at));
            const auto got = pieces_.tiled ? TIFFReadEncodedTile(tiff_.get(), number, tile.data(), wanted)
                                           : TIFFReadEncodedStrip(tiff_.get(), number, pixels.data() + at, wanted);
            if (got != wanted) fail(TIFFGetStrileOffset(tiff_.get(), number));
            if (pieces_.tiled) place_tile(tile, k, pixels);
        }
        return pixels;
    }

    [[nodiscard]] std::vector<std::uint32_t> colours() {
        std::vector<std::uint32_t> pixels(pieces_.nx * pieces_.ny);
        constexpr int stop_where_damaged = 1;
        if (!TIFFReadRGBAImageOriented(tiff_.get(), static_cast<std::uint32_t>(pieces_.nx),
                                       static_cast<std::uint32_t>(pieces_.ny), pixels.data(), ORIENTATION_TOPLEFT,
                                       stop_where_damaged))
            fail(pieces_.directory);
        return pixels;
    }

private:
    [[noreturn]] void fail(std::uint64_t offset) const {
        throw FormatError(stream_.source.name, {.offset = offset},
                          fmt::format("{}: pixels cannot be expanded: {}", format_,
                                      stream_.complaint.empty() ? "the pixels are damaged" : stream_.complaint));
    }

    /// Copies rows and columns of a tile inside the picture to their place.
    void place_tile(const std::string& tile, std::uint64_t number, std::string& pixels) const {
        const auto tile_row = pieces_.piece_nx * pieces_.pixel_bytes;
        const auto left = number % pieces_.across() * tile_row, top = number / pieces_.across() * pieces_.piece_ny;
        const auto width = std::min(tile_row, pieces_.row_bytes() - left),
                   height = std::min(pieces_.piece_ny, pieces_.ny - top);
        for (std::uint64_t row = 0; row < height; ++row)
            std::memcpy(pixels.data() + (top + row) * pieces_.row_bytes() + left, tile.data() + row * tile_row, width);
    }

    Stream stream_;
    const std::string& format_;
    const TiffPieces& pieces_;
    std::unique_ptr<TIFF, CloseTiff> tiff_;
};

}  // namespace

std::string expanded_tiff(const Source& source, const std::string& format, const TiffPieces& pieces,
                          std::uint64_t max_memory) {
    return Page(source, format, pieces, max_memory).rows();
}

std::vector<std::uint32_t> tiff_colours(const Source& source, const std::string& format, const TiffPieces& pieces,
                                        std::uint64_t max_memory) {
    return Page(source, format, pieces, max_memory).colours();
}

}  // namespace setae::bytes
