// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// Whether bytes belong to a format. Any `yes` has priority over `maybe`.
enum class Match { no, maybe, yes };

/// A file format of topographies: description, capabilities and functions. Detection, `setae formats`,
/// docs/reference/formats and the tests use the table of all formats. Texts are sentences without final full stop.
struct Format {
    std::string identifier;             ///< short and stable, such as "di"
    std::string name;                   ///< such as "Nanoscope"
    std::string extensions;             ///< usual endings, separated by blanks; not used for detection
    std::string description;            ///< instruments and content that is read, in one sentence
    std::string heights;                ///< conversion of stored values to heights in metres, and which values are
                                        ///< undefined
    std::string orientation;            ///< which corner is first, and the source of this information
    std::string not_read = {};          ///< further content of such files, and how setae treats it
    std::string reference;              ///< description of the layout
    bool tested_on_real_files = false;  ///< tested on files of instruments, not only on files made by the tests
    bool carries_scale = true;          ///< unit and scale of heights come from the file
    bool read_elsewhere = true;         ///< SurfaceTopography 1.27.1 opens such files
    bool is_container = false;          ///< each channel of heights is a separate measurement
    /// from the first `bytes::detection_bytes` bytes, and for archives from the names of their members
    std::function<Match(std::string_view head, const bytes::Source&)> detect;
    std::function<std::vector<Channel>(const bytes::Source&, const ReadOptions&)> open;
    /// writes one measurement, as a whole; empty if setae only reads the format
    std::function<void(const std::string& path, const topography::Measurement&)> write = {};

    [[nodiscard]] bool writes() const { return static_cast<bool>(write); }
};

/// All formats, in the order of detection.
[[nodiscard]] const std::vector<Format>& formats();

/// The format of a source.
/// @throws FormatError if no format recognises it; the message shows the first bytes.
[[nodiscard]] const Format& detect_format(const bytes::Source& source);

/// The format for writing a file with this ending, such as ".x3p".
/// @throws InvalidArgument for an ending that cannot be written; the message lists the possible ones.
[[nodiscard]] const Format& format_to_write(const std::string& path);

/// The channels of a source; see open() for a path.
[[nodiscard]] std::vector<Channel> open(const bytes::Source& source, const ReadOptions& options);
/// The channels of a source with known format.
[[nodiscard]] std::vector<Channel> open(const bytes::Source& source, const Format& format, const ReadOptions& options);

}  // namespace setae::formats
