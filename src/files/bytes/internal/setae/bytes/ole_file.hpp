// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// Whether bytes begin as a compound file.
[[nodiscard]] bool is_ole(std::string_view head);

/// A compound file (OLE, "structured storage"): a file system of streams within a file, its sectors chained by a table.
/// The table and the directory are read, streams are not.
///
/// Implemented here because libgsf 1.14 leaks memory on damaged directories, logs to stderr, and ends the program if
/// memory is short. Source: [MS-CFB] Compound File Binary File Format, versions 3 and 4.
class OleFile {
public:
    /// @throws FormatError "<format>: …" for circular chains and chains that leave the file.
    OleFile(const Source& source, std::string format);

    /// Streams of all folders.
    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] bool has(const std::string& name) const;

    /// The stream as a source named "file: stream" that reads from the file on request.
    /// @throws FormatError for a missing stream, or one that is not wholly in the file.
    [[nodiscard]] Source stream(const std::string& name) const;

private:
    struct Stream {
        std::string name;
        std::uint32_t first = 0;
        std::uint64_t size = 0;
    };

    [[noreturn]] void fail(std::uint64_t offset, const std::string& what) const;
    void read_table();
    void read_directory(std::uint32_t first, std::uint32_t first_of_small_table);
    /// Sectors of a chain: `count` of them, or all if 0.
    [[nodiscard]] std::vector<std::uint32_t> chain(const std::vector<std::uint32_t>& table, std::uint32_t first,
                                                   std::uint64_t count) const;
    [[nodiscard]] std::vector<std::uint32_t> numbers(const std::vector<std::uint32_t>& sectors) const;
    [[nodiscard]] std::uint64_t offset_of(std::uint32_t sector) const {
        return (std::uint64_t{sector} + 1) * sector_bytes_;
    }
    [[nodiscard]] std::uint64_t small_offset_of(std::uint32_t sector) const;

    Source source_;
    std::string format_;
    std::uint64_t sector_bytes_ = 512, small_sector_bytes_ = 64, min_large_ = 4096;
    std::uint64_t sectors_ = 0;  ///< maximum number by the size of the file
    std::vector<std::uint32_t> table_, small_table_, small_stream_;
    std::vector<Stream> streams_;
};

}  // namespace setae::bytes
