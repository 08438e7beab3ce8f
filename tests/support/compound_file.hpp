// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "byte_builder.hpp"
#include "sample_files.hpp"

namespace setae::tests {

/// A compound file ([MS-CFB]) of streams, with sectors of 2^shift bytes. Streams of 4096 bytes and more lie in sectors
/// of their own, the last first so that chains are followed; shorter ones in the small stream.
class CompoundFile {
public:
    explicit CompoundFile(const Members& streams, unsigned shift = 9)
        : sector_(std::size_t{1} << shift), shift_(shift) {
        for (const auto& [name, content] : streams) {
            const bool small = content.size() < 4096;
            entries_.push_back({name, small ? static_cast<std::uint32_t>(small_.size() / 64) : store_backwards(content),
                                content.size()});
            if (small) add_small(content);
        }
        const auto small_stream = store(small_);
        std::string small_table;
        for (const auto next : small_table_) small_table += ByteBuilder().number(next).content();
        small_table.resize((small_table.size() + sector_ - 1) / sector_ * sector_, '\xff');
        const auto small_table_at = store(small_table);
        const auto directory_at = store(directory(small_stream, (entries_.size() + 1) * 128));
        finish(small_table_at, small_table.size() / sector_, directory_at);
    }

    [[nodiscard]] const std::string& content() const { return file_; }

private:
    static constexpr std::uint32_t end_of_chain = 0xfffffffe, unused = 0xffffffff, table_sector = 0xfffffffd,
                                   list_sector = 0xfffffffc;
    static constexpr std::size_t in_header = 109;
    struct Stream {
        std::string name;
        std::uint32_t first;
        std::size_t size;
    };

    std::string padded(std::string content) const {
        content.resize((content.size() + sector_ - 1) / sector_ * sector_, '\0');
        return content;
    }
    std::uint32_t store(const std::string& content) {
        const auto first = static_cast<std::uint32_t>(table_.size()),
                   count = static_cast<std::uint32_t>(padded(content).size() / sector_);
        for (std::uint32_t i = 1; i <= count; ++i) table_.push_back(i == count ? end_of_chain : first + i);
        sectors_ += padded(content);
        return count ? first : end_of_chain;
    }
    std::uint32_t store_backwards(const std::string& content) {
        const auto first = static_cast<std::uint32_t>(table_.size());
        const auto whole = padded(content);
        const auto count = static_cast<std::uint32_t>(whole.size() / sector_);
        for (std::uint32_t i = 0; i < count; ++i) {
            sectors_ += whole.substr((count - 1 - i) * sector_, sector_);
            table_.push_back(i == 0 ? end_of_chain : first + i - 1);
        }
        return first + count - 1;
    }
    void add_small(const std::string& content) {
        const auto count = (content.size() + 63) / 64;
        const auto first = static_cast<std::uint32_t>(small_table_.size());
        for (std::uint32_t i = 1; i <= count; ++i) small_table_.push_back(i == count ? end_of_chain : first + i);
        small_ += content;
        small_.resize(small_table_.size() * 64, '\0');
    }
    static std::string entry(const std::string& name, std::uint8_t type, std::uint32_t right, std::uint32_t child,
                             std::uint32_t first, std::size_t size) {
        ByteBuilder bytes;
        for (const char c : name) bytes.text(std::string{c, '\0'});
        bytes.pad_to(64).number(static_cast<std::uint16_t>(2 * (name.size() + 1))).number(type).number(std::uint8_t{1});
        bytes.number(unused).number(right).number(child).pad_to(116).number(first).number(
            static_cast<std::uint64_t>(size));
        return bytes.content();
    }
    std::string directory(std::uint32_t small_stream, std::size_t bytes) const {
        auto entries = entry("Root Entry", 5, unused, 1, small_stream, small_.size());
        for (std::size_t i = 0; i < entries_.size(); ++i)
            entries += entry(entries_[i].name, 2, i + 1 < entries_.size() ? static_cast<std::uint32_t>(i + 2) : unused,
                             unused, entries_[i].first, entries_[i].size);
        entries.resize(bytes);
        return entries;
    }
    void finish(std::uint32_t small_table_at, std::size_t small_table_sectors, std::uint32_t directory_at) {
        const auto per_sector = sector_ / 4;
        std::size_t count = 1,
                    lists = 0;  // sectors of the table, and of the list of them that the header has no room for
        while (count * per_sector < table_.size() + count + lists) {
            ++count;
            lists = count > in_header ? (count - in_header + per_sector - 2) / (per_sector - 1) : 0;
        }
        const auto first = static_cast<std::uint32_t>(table_.size()),
                   first_list = static_cast<std::uint32_t>(first + count);
        table_.resize(table_.size() + count, table_sector);
        table_.resize(table_.size() + lists, list_sector);
        table_.resize(count * per_sector, unused);
        ByteBuilder header;
        header.text("\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1")
            .pad_to(24)
            .number(std::uint16_t{0x3e})
            .number(static_cast<std::uint16_t>(shift_ == 9 ? 3 : 4))
            .number(std::uint16_t{0xfffe});
        header.number(static_cast<std::uint16_t>(shift_))
            .number(std::uint16_t{6})
            .pad_to(44)
            .number(static_cast<std::uint32_t>(count))
            .number(directory_at)
            .number(0u)
            .number(4096u);
        header.number(small_table_sectors ? small_table_at : end_of_chain)
            .number(static_cast<std::uint32_t>(small_table_sectors));
        header.number(lists ? first_list : end_of_chain).number(static_cast<std::uint32_t>(lists));
        for (std::uint32_t i = 0; i < in_header; ++i) header.number(i < count ? first + i : unused);
        header.pad_to(sector_);
        file_ = header.content() + sectors_;
        for (const auto next : table_) file_ += ByteBuilder().number(next).content();
        auto listed = static_cast<std::uint32_t>(in_header);
        for (std::size_t list = 0; list < lists; ++list) {
            for (std::size_t i = 0; i + 1 < per_sector; ++i, ++listed)
                file_ += ByteBuilder().number(listed < count ? first + listed : unused).content();
            file_ += ByteBuilder()
                         .number(list + 1 < lists ? static_cast<std::uint32_t>(first_list + list + 1) : end_of_chain)
                         .content();
        }
    }

    std::size_t sector_;
    unsigned shift_;
    std::vector<Stream> entries_;
    std::vector<std::uint32_t> table_, small_table_;
    std::string sectors_, small_, file_;
};

}  // namespace setae::tests
