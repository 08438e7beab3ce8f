// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>  // before jpeglib.h, which needs FILE

#include <jpeglib.h>
#include <png.h>
#include <tiffio.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace setae::imaging::tests {

/// Pictures of any depth supported by libpng: grey, or blue, green and red.
inline std::string png_bytes(const cv::Mat& image) {
    std::string file;
    auto* png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    auto* info = png_create_info_struct(png);
    const auto append = [](png_structp from, png_bytep bytes, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(from))->append(reinterpret_cast<const char*>(bytes), count);
    };
    png_set_write_fn(png, &file, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.cols), static_cast<png_uint_32>(image.rows),
                 image.depth() == CV_16U ? 16 : 8, image.channels() == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_set_bgr(png);
    png_set_swap(png);
    for (int row = 0; row < image.rows; ++row) png_write_row(png, image.ptr(row));
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

/// 8 bits, grey or blue, green and red.
inline std::string jpeg_bytes(const cv::Mat& image, int quality = 95) {
    cv::Mat pixels = image;
    if (image.channels() == 3) cv::cvtColor(image, pixels, cv::COLOR_BGR2RGB);
    jpeg_error_mgr errors;
    jpeg_compress_struct jpeg;
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* bytes = nullptr;
    unsigned long count = 0;
    jpeg_mem_dest(&jpeg, &bytes, &count);
    jpeg.image_width = static_cast<JDIMENSION>(image.cols);
    jpeg.image_height = static_cast<JDIMENSION>(image.rows);
    jpeg.input_components = image.channels();
    jpeg.in_color_space = image.channels() == 3 ? JCS_RGB : JCS_GRAYSCALE;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, quality, TRUE);
    jpeg_start_compress(&jpeg, TRUE);
    for (int row = 0; row < image.rows; ++row) {
        JSAMPROW line = pixels.ptr(row);
        jpeg_write_scanlines(&jpeg, &line, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    const std::string file(reinterpret_cast<const char*>(bytes), count);
    std::free(bytes);
    return file;
}

/// 8 bits of grey, rows from the bottom.
inline std::string bmp_bytes(const cv::Mat& image) {
    const auto number = [](std::int64_t value, int count) {
        std::string text;
        for (int k = 0; k < count; ++k) text += static_cast<char>((value >> (8 * k)) & 255);
        return text;
    };
    std::string palette, pixels;
    for (int k = 0; k < 256; ++k) palette += std::string(3, static_cast<char>(k)) + '\0';
    for (int row = image.rows - 1; row >= 0; --row) {
        pixels.append(image.ptr<char>(row), static_cast<std::size_t>(image.cols));
        pixels.resize((pixels.size() + 3) / 4 * 4, '\0');
    }
    const auto begin = static_cast<std::int64_t>(54 + palette.size());
    return "BM" + number(begin + static_cast<std::int64_t>(pixels.size()), 4) + number(0, 4) + number(begin, 4) +
           number(40, 4) + number(image.cols, 4) + number(image.rows, 4) + number(1, 2) + number(8, 2) +
           std::string(24, '\0') + palette + pixels;
}

/// Pages of grey, 8 or 16 bits or floats, written by libtiff, directories after pixels.
inline void write_tiff(const std::string& path, const std::vector<cv::Mat>& pages, int compression = COMPRESSION_LZW) {
    auto* const tiff = TIFFOpen(path.c_str(), "w");
    if (!tiff) throw std::runtime_error(path + ": libtiff cannot write");
    for (const auto& page : pages) {
        const auto bits = 8 * static_cast<int>(page.elemSize());
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, page.cols);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, page.rows);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
        TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, page.depth() == CV_32F ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(tiff, TIFFTAG_COMPRESSION, compression);
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 8);
        if (page.depth() != CV_32F && compression != COMPRESSION_PACKBITS)
            TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
        for (int row = 0; row < page.rows; ++row) {
            std::vector<unsigned char> line(page.ptr(row),
                                            page.ptr(row) + static_cast<std::size_t>(page.cols) * page.elemSize());
            TIFFWriteScanline(tiff, line.data(), static_cast<std::uint32_t>(row), 0);
        }
        TIFFWriteDirectory(tiff);
    }
    TIFFClose(tiff);
}

/// By the ending of a file's name: .png, .jpg or .bmp.
inline std::string picture_bytes(const cv::Mat& image, const std::string& ending) {
    return ending == ".png" ? png_bytes(image) : ending == ".jpg" ? jpeg_bytes(image) : bmp_bytes(image);
}

/// A PNG as blue, green and red.
inline cv::Mat3b png_pixels(const std::string& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, path.c_str())) throw std::runtime_error(path + ": " + image.message);
    image.format = PNG_FORMAT_BGR;
    cv::Mat3b picture(static_cast<int>(image.height), static_cast<int>(image.width));
    if (!png_image_finish_read(&image, nullptr, picture.data, 0, nullptr))
        throw std::runtime_error(path + ": " + image.message);
    return picture;
}

}  // namespace setae::imaging::tests
