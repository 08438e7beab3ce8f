// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "byte_builder.hpp"

namespace setae::tests {

/// A page of a TIFF file to be: its entries, and strips or tiles of pixels.
class TiffPageBuilder {
public:
    explicit TiffPageBuilder(std::endian order) : order_(order) {}

    TiffPageBuilder& shorts(std::uint16_t id, const std::vector<std::uint16_t>& values) {
        return numbers(id, 3, values);
    }
    TiffPageBuilder& longs(std::uint16_t id, const std::vector<std::uint32_t>& values) {
        return numbers(id, 4, values);
    }
    TiffPageBuilder& signed_short(std::uint16_t id, std::int16_t value) { return numbers(id, 8, std::vector{value}); }
    TiffPageBuilder& signed_long(std::uint16_t id, std::int32_t value) { return numbers(id, 9, std::vector{value}); }
    TiffPageBuilder& real(std::uint16_t id, double value) { return numbers(id, 12, std::vector{value}); }
    TiffPageBuilder& text(std::uint16_t id, std::string_view value) {
        return raw(id, 2, value.size() + 1, std::string(value) + '\0');
    }
    TiffPageBuilder& bytes(std::uint16_t id, const std::string& value, std::uint16_t type = 7) {
        return raw(id, type, value.size(), value);
    }

    /// Size and type of the pixels; kind 1 unsigned, 2 signed, 3 float.
    TiffPageBuilder& picture(int nx, int ny, int bits, int kind, int compression = 1) {
        return longs(256, {static_cast<std::uint32_t>(nx)})
            .longs(257, {static_cast<std::uint32_t>(ny)})
            .shorts(258, {static_cast<std::uint16_t>(bits)})
            .shorts(259, {static_cast<std::uint16_t>(compression)})
            .shorts(262, {1})
            .shorts(277, {1})
            .shorts(339, {static_cast<std::uint16_t>(kind)});
    }
    TiffPageBuilder& strips(int rows, std::vector<std::string> pieces) {
        longs(278, {static_cast<std::uint32_t>(rows)});
        pieces_ = std::move(pieces);
        return *this;
    }
    TiffPageBuilder& tiles(int nx, int ny, std::vector<std::string> pieces) {
        longs(322, {static_cast<std::uint32_t>(nx)}).longs(323, {static_cast<std::uint32_t>(ny)});
        pieces_ = std::move(pieces);
        tiled_ = true;
        return *this;
    }

    struct Entry {
        std::uint16_t id, type;
        std::uint64_t count;
        std::string value;
    };
    [[nodiscard]] std::vector<Entry> entries() const {
        auto sorted = entries_;
        std::stable_sort(sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
        return sorted;
    }
    [[nodiscard]] const std::vector<std::string>& pieces() const { return pieces_; }
    [[nodiscard]] bool tiled() const { return tiled_; }

private:
    template <class T>
    TiffPageBuilder& numbers(std::uint16_t id, std::uint16_t type, const std::vector<T>& values) {
        ByteBuilder builder(order_);
        for (const auto value : values) builder.number(value);
        return raw(id, type, values.size(), builder.content());
    }
    TiffPageBuilder& raw(std::uint16_t id, std::uint16_t type, std::uint64_t count, const std::string& value) {
        entries_.push_back({id, type, count, value});
        return *this;
    }

    std::endian order_;
    std::vector<Entry> entries_;
    std::vector<std::string> pieces_;
    bool tiled_ = false;
};

/// A TIFF file, or BigTIFF: for each page its pieces of pixels, the values that do not fit in entries, and the
/// directory.
[[nodiscard]] inline std::string tiff_file(std::endian order, std::vector<TiffPageBuilder> pages, bool big = false) {
    ByteBuilder file(order);
    file.text(order == std::endian::little ? "II" : "MM").template number<std::uint16_t>(big ? 43 : 42);
    if (big) file.number<std::uint16_t>(8).number<std::uint16_t>(0);
    const auto offset_bytes = big ? 8u : 4u;
    const auto put_long = [&](ByteBuilder& target, std::size_t value) {
        big ? target.number<std::uint64_t>(value) : target.number(static_cast<std::uint32_t>(value));
    };
    const auto put_long_at = [&](std::size_t at, std::size_t value) {
        big ? file.number_at<std::uint64_t>(at, value) : file.number_at(at, static_cast<std::uint32_t>(value));
    };
    std::size_t link = file.size();
    put_long(file, 0);
    for (auto& page : pages) {
        std::vector<std::uint32_t> offsets, counts;
        for (const auto& piece : page.pieces()) {
            offsets.push_back(static_cast<std::uint32_t>(file.size()));
            counts.push_back(static_cast<std::uint32_t>(piece.size()));
            file.text(piece);
        }
        if (!offsets.empty()) page.longs(page.tiled() ? 324 : 273, offsets).longs(page.tiled() ? 325 : 279, counts);
        const auto entries = page.entries();
        std::vector<std::size_t> places;
        for (const auto& entry : entries) {
            places.push_back(file.size());
            if (entry.value.size() > offset_bytes) file.text(entry.value);
        }
        if (file.size() % 2 != 0) file.text(std::string(1, '\0'));
        put_long_at(link, file.size());
        big ? file.number<std::uint64_t>(entries.size()) : file.number(static_cast<std::uint16_t>(entries.size()));
        for (std::size_t k = 0; k < entries.size(); ++k) {
            const auto& entry = entries[k];
            file.number(entry.id).number(entry.type);
            put_long(file, entry.count);
            if (entry.value.size() > offset_bytes) put_long(file, places[k]);
            else file.text(entry.value, offset_bytes);
        }
        link = file.size();
        put_long(file, 0);
    }
    return file.content();
}

}  // namespace setae::tests
