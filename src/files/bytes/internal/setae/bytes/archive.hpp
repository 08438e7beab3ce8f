// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// Whether bytes begin as a ZIP archive.
[[nodiscard]] bool is_zip(std::string_view head);

/// Whether the name of a member remains inside the folder of the archive: no "../x", "/x", "c:x".
[[nodiscard]] bool stays_inside(std::string_view name);

/// A ZIP archive open for reading: a file, a part of one, or bytes in memory. Only its directory, once, and requested
/// members are read. Copies and members share the archive.
class Archive {
public:
    /// @throws FormatError for an incomplete ZIP archive, or a member whose name leads out of it ("../x", "/x").
    explicit Archive(const Source& source);

    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// Size of a member by the directory. @throws FormatError for a missing member.
    [[nodiscard]] std::uint64_t size(const std::string& name) const;

    /// Content of a member; memory is allocated by the actual content, not by the size in the directory.
    /// @throws FormatError for a missing, damaged or encrypted member, or one that expands to more than max_expanded.
    [[nodiscard]] std::string read(const std::string& name) const;
    /// The first `count` bytes of a member, or all bytes of a shorter one.
    [[nodiscard]] std::string head(const std::string& name, std::uint64_t count) const;

    /// The member as a source named "archive: member". A read within its first MiB expands only the beginning; a read
    /// beyond expands and keeps the whole member. A member that differs from its size in the directory is refused at
    /// that read. The source outlives the archive.
    [[nodiscard]] Source member(const std::string& name) const;

private:
    class Opened;

    std::shared_ptr<Opened> opened_;
};

}  // namespace setae::bytes
