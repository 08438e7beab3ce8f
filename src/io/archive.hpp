// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "setae/io/source.hpp"

struct zip;

namespace setae::io {

/// Whether bytes begin as a ZIP archive.
[[nodiscard]] bool is_zip(std::string_view head);

/// A ZIP archive open for reading, on disk or in memory.
class Archive {
public:
    /// @throws FormatError for bytes that are no whole ZIP archive.
    explicit Archive(const Source& source);

    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] bool has(const std::string& name) const;

    /// A member's content; memory grows with what is really there, never with what the directory announces.
    /// @throws FormatError for a missing, damaged or encrypted member.
    [[nodiscard]] std::string read(const std::string& name) const;

    /// The member as a source named "archive: member".
    [[nodiscard]] Source member(const std::string& name) const;

private:
    struct Close {
        void operator()(zip* archive) const;
    };

    Source source_;
    std::shared_ptr<const std::string> content_;  ///< of an archive in memory; libzip reads from it
    std::unique_ptr<zip, Close> zip_;
};

}  // namespace setae::io
