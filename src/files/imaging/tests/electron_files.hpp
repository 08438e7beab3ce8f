// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "micrograph_files.hpp"

namespace setae::imaging::tests {

/// An MRC of one or more sections of the common picture.
struct MrcFile {
    bool big_endian = false;
    int mode = 2;
    std::string pixels;  ///< of all sections, in the byte order of the file
    std::uint64_t sections = 1;
    float cell_x = 1.5f, cell_y = 0.5f;  ///< [Å]
    std::string extended, extended_kind = std::string(4, '\0');

    [[nodiscard]] Bytes order() const { return {big_endian}; }
    [[nodiscard]] std::string bytes() const {
        const auto whole = [&](std::uint64_t value) { return order().whole(value, 4); };
        std::string header = whole(columns) + whole(rows) + whole(sections) + whole(static_cast<std::uint64_t>(mode)) +
                             std::string(12, '\0') + whole(columns) + whole(rows) + whole(sections) +
                             order().real32(cell_x) + order().real32(cell_y) + order().real32(1);
        header.resize(92, '\0');
        header += whole(extended.size()) + std::string(8, '\0') + extended_kind;
        header.resize(208, '\0');
        header += "MAP " + (big_endian ? std::string("\x11\x11\0\0", 4) : std::string("DD\0\0", 4));
        header.resize(1024, '\0');
        return header + extended + pixels;
    }
};

inline MrcFile mrc_file(bool big_endian = false) {
    MrcFile file{.big_endian = big_endian};
    for (int i = 1; i <= columns * rows; ++i) file.pixels += file.order().real32(static_cast<float>(i));
    return file;
}

/// A series of TIA with images of the common picture, whose rows it stores from the bottom up.
struct SerFile {
    int version = 0x0210;
    int type = 7;        ///< of the numbers: float32
    int kind = 0x4122;   ///< of the data: pictures
    std::string pixels;  ///< of one image
    std::uint64_t images = 1;
    double step_x = 0.5e-9, step_y = 0.25e-9;  ///< [m]

    [[nodiscard]] std::string bytes() const {
        const Bytes little;
        const int word = version == 0x0210 ? 4 : 8;
        std::string head = "II" + little.whole(0x0197, 2) + little.whole(static_cast<std::uint64_t>(version), 2) +
                           little.whole(static_cast<std::uint64_t>(kind), 4) + little.whole(0x4152, 4) +
                           little.whole(images, 4) + little.whole(images, 4);
        const auto list_at = head.size() + static_cast<std::size_t>(word) + 4;
        head += little.whole(list_at, word) + little.whole(0, 4);
        const auto axis = [&](double step) { return little.real64(0) + little.real64(step) + little.whole(0, 4); };
        const auto image = axis(step_x) + axis(step_y) + little.whole(static_cast<std::uint64_t>(type), 2) +
                           little.whole(columns, 4) + little.whole(rows, 4) + pixels;
        std::string list, body;
        for (std::uint64_t i = 0; i < images; ++i) {
            list += little.whole(list_at + 2 * images * static_cast<std::uint64_t>(word) + body.size(), word);
            body += image;
        }
        return head + list + std::string(list.size(), '\0') + body;
    }
};

/// The common picture, its lower row first.
inline SerFile ser_file(int version = 0x0210) {
    SerFile file{.version = version};
    for (const int i : {4, 5, 6, 1, 2, 3}) file.pixels += Bytes{}.real32(static_cast<float>(i));
    return file;
}

}  // namespace setae::imaging::tests
