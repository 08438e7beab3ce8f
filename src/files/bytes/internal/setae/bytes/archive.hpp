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

/// Whether a member's name stays in the archive's own folder: no "../x", "/x", "c:x".
[[nodiscard]] bool stays_inside(std::string_view name);

/// A ZIP archive open for reading: a file, a part of one, or bytes in memory. Only its directory, once, and the members
/// asked for are read. Copies and members share it.
class Archive {
public:
    /// @throws FormatError for bytes that are no whole ZIP archive, or a member whose name leads out of it ("../x",
    /// "/x").
    explicit Archive(const Source& source);

    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// Bytes of a member as the directory announces them. @throws FormatError for a missing member.
    [[nodiscard]] std::uint64_t size(const std::string& name) const;

    /// A member's content; memory grows with what is really there, never with what the directory announces.
    /// @throws FormatError for a missing, damaged or encrypted member, or one that expands more than max_expanded.
    [[nodiscard]] std::string read(const std::string& name) const;
    /// The first `count` bytes of a member, or all where there are fewer.
    [[nodiscard]] std::string head(const std::string& name, std::uint64_t count) const;

    /// The member as a source named "archive: member". It is expanded at the first read beyond its first MiB and then
    /// kept, and its beginning, as far as it is read, before; a member that does not hold what the directory announces
    /// is refused at that read. It outlives the archive.
    [[nodiscard]] Source member(const std::string& name) const;

private:
    class Opened;

    std::shared_ptr<Opened> opened_;
};

}  // namespace setae::bytes
