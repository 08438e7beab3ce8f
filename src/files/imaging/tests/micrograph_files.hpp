// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace setae::imaging::tests {

/// Bytes of numbers in either order.
struct Bytes {
    bool big_endian = false;

    [[nodiscard]] std::string whole(std::uint64_t value, int bytes) const {
        std::string text;
        for (int i = 0; i < bytes; ++i) text += static_cast<char>((value >> (8 * i)) & 0xFF);
        if (big_endian) std::reverse(text.begin(), text.end());
        return text;
    }
    [[nodiscard]] std::string real32(float value) const { return whole(std::bit_cast<std::uint32_t>(value), 4); }
    [[nodiscard]] std::string real64(double value) const { return whole(std::bit_cast<std::uint64_t>(value), 8); }
};

/// A picture of three columns and two rows with the values 1, 2, 3 above 4, 5, 6, used by every builder here.
constexpr int columns = 3, rows = 2;

/// A DM3 or DM4 with a thumbnail of one pixel, and the image.
struct DmFile {
    int version = 3;
    bool big_endian = false;
    int data_type = 2;   ///< of ImageData
    int element = 6;     ///< of its array: float32
    std::string pixels;  ///< in the byte order of the file
    std::vector<std::uint64_t> dimensions{columns, rows};
    std::vector<std::pair<double, std::string>> scales{{0.5, "nm"}, {0.25, "nm"}};  ///< unit as ISO 8859-1
    bool pairs = false;  ///< each pixel is a structure of two numbers, as complex ones are stored

    [[nodiscard]] Bytes order() const { return {big_endian}; }
    [[nodiscard]] std::string word(std::uint64_t value) const { return Bytes{true}.whole(value, version == 4 ? 8 : 4); }
    [[nodiscard]] std::string entry(int kind, const std::string& name, const std::string& body) const {
        return Bytes{true}.whole(static_cast<std::uint64_t>(kind), 1) + Bytes{true}.whole(name.size(), 2) + name +
               (version == 4 ? Bytes{true}.whole(body.size(), 8) : "") + body;
    }
    [[nodiscard]] std::string members(const std::vector<std::string>& entries) const {
        std::string body = std::string("\x01\x00", 2) + word(entries.size());
        for (const auto& one : entries) body += one;
        return body;
    }
    [[nodiscard]] std::string group(const std::string& name, const std::vector<std::string>& entries) const {
        return entry(20, name, members(entries));
    }
    [[nodiscard]] std::string tag(const std::string& name, const std::vector<std::uint64_t>& type,
                                  const std::string& value) const {
        std::string body = "%%%%" + word(type.size());
        for (const auto one : type) body += word(one);
        return entry(21, name, body + value);
    }
    [[nodiscard]] std::string count(const std::string& name, std::uint64_t value) const {
        return tag(name, {5}, order().whole(value, 4));
    }
    [[nodiscard]] std::string real(const std::string& name, double value) const {
        return tag(name, {7}, order().real64(value));
    }
    [[nodiscard]] std::string text(const std::string& name, const std::string& value) const {
        std::string wide;
        for (const char c : value) wide += order().whole(static_cast<unsigned char>(c), 2);
        return tag(name, {20, 4, value.size()}, wide);
    }
    [[nodiscard]] std::string image(const std::vector<std::uint64_t>& sides, const std::string& data, int type,
                                    int array_of, std::uint64_t elements, bool calibrated) const {
        std::vector<std::string> lengths, axes;
        for (const auto side : sides) lengths.push_back(count("", side));
        if (calibrated)
            for (const auto& [scale, unit] : scales)
                axes.push_back(group("", {real("Origin", 0), real("Scale", scale), text("Units", unit)}));
        const auto number = static_cast<std::uint64_t>(array_of);
        const auto array = pairs && calibrated
                               ? std::vector<std::uint64_t>{20, 15, 0, 2, 0, number, 0, number, elements}
                               : std::vector<std::uint64_t>{20, number, elements};
        const auto point = tag("Rectangle", {15, 0, 2, 0, 6, 0, 6},
                               order().real32(1) + order().real32(2));  // a structure to be skipped
        return group(
            "",
            {group("ImageData", {group("Calibrations", {group("Dimension", axes)}), tag("Data", array, data),
                                 count("DataType", static_cast<std::uint64_t>(type)), group("Dimensions", lengths)}),
             group("ImageTags",
                   {point,
                    group("Microscope Info",
                          {real("Voltage", 2e5), real("Indicated Magnification", 1e5), text("Name", "JEM")}),
                    group("DataBar", {text("Acquisition Date", "1/2/2020"), text("Acquisition Time", "3:04")})})});
    }
    [[nodiscard]] std::string bytes() const {
        const auto thumbnail = image({1, 1}, std::string(4, '\x7F'), 23, 5, 1, false);
        std::uint64_t elements = 1;
        for (const auto side : dimensions) elements *= side;
        const auto root =
            members({group("ImageList", {thumbnail, image(dimensions, pixels, data_type, element, elements, true)}),
                     group("ImageSourceList", {group("", {count("ImageRef", 1)})}),
                     group("Thumbnails", {group("", {count("ImageIndex", 0)})})});
        return Bytes{true}.whole(static_cast<std::uint64_t>(version), 4) + word(root.size() + 4) +
               Bytes{true}.whole(big_endian ? 0 : 1, 4) + root + std::string(8, '\0');
    }
};

/// The DM file of the common picture as float32.
inline DmFile dm_file(int version = 3, bool big_endian = false) {
    DmFile file{.version = version, .big_endian = big_endian};
    for (int i = 1; i <= columns * rows; ++i) file.pixels += file.order().real32(static_cast<float>(i));
    return file;
}

struct TiffField {
    int tag, type;
    std::uint64_t count;
    std::string value;  ///< in the byte order of the file
};

/// An uncompressed TIFF of pages of 16 bits with the common picture, one strip each.
struct TiffFile {
    bool big_endian = false, big_tiff = false;

    [[nodiscard]] Bytes order() const { return {big_endian}; }
    [[nodiscard]] TiffField shorts(int tag, std::uint64_t value) const { return {tag, 3, 1, order().whole(value, 2)}; }
    [[nodiscard]] TiffField longs(int tag, std::uint64_t value) const { return {tag, 4, 1, order().whole(value, 4)}; }
    [[nodiscard]] TiffField ratio(int tag, std::uint64_t above, std::uint64_t below) const {
        return {tag, 5, 1, order().whole(above, 4) + order().whole(below, 4)};
    }
    [[nodiscard]] TiffField real(int tag, double value) const { return {tag, 12, 1, order().real64(value)}; }
    [[nodiscard]] TiffField text(int tag, const std::string& value) const {
        return {tag, 2, value.size() + 1, value + '\0'};
    }

    /// Fields of each page in addition to those of the picture; a given field replaces one of the picture.
    [[nodiscard]] std::string bytes(const std::vector<std::vector<TiffField>>& pages = {{}}) const {
        const std::size_t word = big_tiff ? 8 : 4;
        const auto pointer = [&](std::uint64_t value) { return order().whole(value, static_cast<int>(word)); };
        std::string file = std::string(big_endian ? "MM" : "II") + order().whole(big_tiff ? 43 : 42, 2) +
                           (big_tiff ? order().whole(8, 2) + order().whole(0, 2) : "");
        file += pointer(file.size() + word);
        for (std::size_t k = 0; k < pages.size(); ++k) {
            std::string pixels;
            for (std::uint64_t i = 1; i <= columns * rows; ++i) pixels += order().whole(i, 2);
            std::vector<TiffField> fields{longs(256, columns), longs(257, rows),         shorts(258, 16),
                                          shorts(259, 1),      shorts(262, 1),           longs(273, 0),
                                          shorts(277, 1),      longs(279, pixels.size())};
            for (const auto& field : pages[k]) {
                std::erase_if(fields, [&](const TiffField& other) { return other.tag == field.tag; });
                fields.push_back(field);
            }
            std::sort(fields.begin(), fields.end(),
                      [](const auto& one, const auto& other) { return one.tag < other.tag; });
            std::string values;
            const auto values_at = file.size() + (big_tiff ? 8 + 20 * fields.size() : 2 + 12 * fields.size()) + word;
            for (const auto& field : fields) values += field.value.size() > word ? field.value : "";
            const auto pixels_at = values_at + values.size();
            file += order().whole(fields.size(), big_tiff ? 8 : 2);
            std::size_t value_at = values_at;
            for (auto& field : fields) {
                if (field.tag == 273) field.value = order().whole(pixels_at, 4);
                file += order().whole(static_cast<std::uint64_t>(field.tag), 2) +
                        order().whole(static_cast<std::uint64_t>(field.type), 2) + pointer(field.count);
                if (field.value.size() > word) file += pointer(std::exchange(value_at, value_at + field.value.size()));
                else file += field.value + std::string(word - field.value.size(), '\0');
            }
            file += pointer(k + 1 < pages.size() ? pixels_at + pixels.size() : 0) + values + pixels;
        }
        return file;
    }
};

}  // namespace setae::imaging::tests
