// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// Whether bytes belong to a format. `maybe` gives way to any `yes`.
enum class Match { no, maybe, yes };

/// A file format of topographies: what it is, what setae can do with it, and the functions that do it. Detection,
/// `setae formats`, docs/reference/formats and the tests are made from the one table of these. Texts are sentences
/// without final full stop.
struct Format {
    std::string identifier;             ///< short and stable, such as "di"
    std::string name;                   ///< such as "Nanoscope"
    std::string extensions;             ///< usual endings, separated by blanks; never used to detect
    std::string description;            ///< whose files these are and what is read of them, in a sentence
    std::string heights;                ///< how stored values become heights in metres, and which are undefined
    std::string orientation;            ///< which corner comes first, and what says so
    std::string not_read = {};          ///< what such files may hold besides, and what happens to it
    std::string reference;              ///< where the layout is described
    bool tested_on_real_files = false;  ///< of instruments, not only files made by the tests
    bool carries_scale = true;          ///< heights come with their unit and scale from the file itself
    bool read_elsewhere = true;         ///< the field's Python package, 1.27.1, opens such files
    bool is_container = false;          ///< each channel of heights is a measurement of its own
    /// from the first `bytes::detection_bytes` bytes, and for archives from the names of their members
    std::function<Match(std::string_view head, const bytes::Source&)> detect;
    std::function<std::vector<Channel>(const bytes::Source&, const ReadOptions&)> open;
    /// writes one measurement, as a whole; nothing where setae only reads the format
    std::function<void(const std::string& path, const topography::Measurement&)> write = {};

    [[nodiscard]] bool writes() const { return static_cast<bool>(write); }
};

/// All formats, in the order in which they are asked.
[[nodiscard]] const std::vector<Format>& formats();

/// The format of a source.
/// @throws FormatError where no format recognises it; the message shows the first bytes.
[[nodiscard]] const Format& detect_format(const bytes::Source& source);

/// The format that writes files of this name's ending, such as ".x3p".
/// @throws InvalidArgument for an ending nobody writes; the message lists those that are.
[[nodiscard]] const Format& format_to_write(const std::string& path);

/// The channels of a source, as open() gives them for a path.
[[nodiscard]] std::vector<Channel> open(const bytes::Source& source, const ReadOptions& options);
/// The same for a source whose format is known.
[[nodiscard]] std::vector<Channel> open(const bytes::Source& source, const Format& format, const ReadOptions& options);

}  // namespace setae::formats
