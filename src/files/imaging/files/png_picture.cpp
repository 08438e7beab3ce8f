// SPDX-License-Identifier: GPL-3.0-or-later
#include <png.h>

#include <array>
#include <bit>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "picture_decoders.hpp"
#include "setae/core/errors.hpp"
#include "setae/imaging/opencv_session.hpp"
#include "setae/imaging/png_writer.hpp"

// libpng returns by longjmp on errors: the functions that call it below have no objects to be destroyed.
namespace setae::imaging {
namespace {

using Message = std::array<char, 128>;

[[noreturn]] void leave(png_structp png, png_const_charp why) {
    auto& message = *static_cast<Message*>(png_get_error_ptr(png));
    std::snprintf(message.data(), message.size(), "%s", why);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

struct Reader {
    std::string_view rest;
    Message message{};
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, leave, ignore_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;

    explicit Reader(std::string_view bytes) : rest(bytes) {}
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void take(png_structp png, png_bytep target, std::size_t count) {
    auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
    if (count > rest.size()) png_error(png, "it ends early");
    std::memcpy(target, rest.data(), count);
    rest.remove_prefix(count);
}

/// Reads up to the pixels, which become 8 or 16 bits of grey or colour.
bool read_header(Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_set_read_fn(reader.png, &reader.rest, take);
    png_read_info(reader.png, reader.info);
    const int colour = png_get_color_type(reader.png, reader.info);
    if (colour == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(reader.png);
    if (colour == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(reader.png);
    if (std::endian::native == std::endian::little) png_set_swap(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool read_rows(Reader& reader, png_bytepp rows) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_image(reader.png, rows);
    png_read_end(reader.png, nullptr);
    return true;
}

struct Writer {
    Message message{};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, leave, ignore_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;

    Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { png_destroy_write_struct(&png, &info); }
};

void append(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

bool write(Writer& writer, png_uint_32 width, png_uint_32 height, int colour, png_bytepp rows, std::string* file) {
    if (setjmp(png_jmpbuf(writer.png))) return false;
    png_set_write_fn(writer.png, file, append, nullptr);
    png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_compression_level(writer.png, 1);
    png_set_compression_strategy(writer.png, 3);  // runs: drawings over grey levels
    png_set_IHDR(writer.png, writer.info, width, height, 8, colour, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(writer.png, writer.info);
    png_set_bgr(writer.png);
    png_write_image(writer.png, rows);
    png_write_end(writer.png, writer.info);
    return true;
}

}  // namespace

FrameRead decoded_png(std::string_view bytes, PictureSize size) {
    Reader reader(bytes);
    const auto damaged = [&] { return FrameRead{{}, fmt::format("cannot be decoded: {}", reader.message.data())}; };
    if (!reader.info) return {{}, "cannot be decoded: memory does not suffice"};
    if (!read_header(reader)) return damaged();
    const auto stride = png_get_rowbytes(reader.png, reader.info);
    const int channels = png_get_channels(reader.png, reader.info);
    const bool wide = png_get_bit_depth(reader.png, reader.info) == 16;
    const auto height = static_cast<std::size_t>(size.height);
    // of 2 bytes, for the alignment of both kinds of values
    std::vector<std::uint16_t> pixels((stride * height + 1) / 2);
    auto* const first = reinterpret_cast<png_bytep>(pixels.data());
    std::vector<png_bytep> rows(height);
    for (std::size_t row = 0; row < height; ++row) rows[row] = first + row * stride;
    if (!read_rows(reader, rows.data())) return damaged();
    return {wide ? luminance(pixels.data(), size, channels, static_cast<long>(stride / 2))
                 : luminance(first, size, channels, static_cast<long>(stride)),
            {}};
}

std::string png_of(const cv::Mat& picture) {
    limit_opencv();
    Writer writer;
    std::vector<png_bytep> rows;
    for (int row = 0; row < picture.rows; ++row) rows.push_back(const_cast<png_bytep>(picture.ptr(row)));
    std::string file;
    const int colour = picture.channels() == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB;
    if (!writer.info || !write(writer, static_cast<png_uint_32>(picture.cols), static_cast<png_uint_32>(picture.rows),
                               colour, rows.data(), &file))
        throw InternalError(fmt::format("a picture cannot be written as PNG: {}", writer.message.data()));
    return file;
}

}  // namespace setae::imaging
