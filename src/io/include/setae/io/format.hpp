// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/io/channel.hpp"
#include "setae/io/source.hpp"

namespace setae::io {

/// Whether bytes belong to a format. `maybe` gives way to any `yes`.
enum class Match { no, maybe, yes };

/// A file format of topographies: what it is, what setae can do with it, and the functions that do it. Detection,
/// `setae formats`, the documentation and the tests are made from the one table of these.
struct Format {
    std::string identifier;   ///< short and stable, such as "di"
    std::string name;         ///< such as "Nanoscope"
    std::string extensions;   ///< usual endings, separated by blanks; never used to detect
    std::string description;  ///< layout, scale and orientation in a sentence
    std::string reference;    ///< where the layout is described
    bool reads = true;
    bool writes = false;
    bool tested_on_real_files = false;                     ///< of instruments, not only files made by the tests
    bool carries_scale = true;                             ///< heights come with their unit and scale from the file itself
    /// from the first `detection_bytes` bytes, and for archives from the names of their members
    std::function<Match(std::string_view head, const Source&)> detect;
    std::function<std::vector<Channel>(const Source&, const ReadOptions&)> open;
};

inline constexpr std::size_t detection_bytes = 1 << 16;

/// All formats, in the order in which they are asked.
[[nodiscard]] const std::vector<Format>& formats();

/// The format of a source.
/// @throws FormatError where no format recognises it; the message shows the first bytes.
[[nodiscard]] const Format& detect_format(const Source& source);

/// The channels of a source, as open() gives them for a path.
[[nodiscard]] std::vector<Channel> open(const Source& source, const ReadOptions& options);

}  // namespace setae::io
