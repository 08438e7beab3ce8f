// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"

/// The header of a Nanosurf file: sections "[name]" of lines "key=value", then "#!" and the integers of all channels in
/// the order of "Gr<group>-Ch<channel>" of the first section, "DataSet".
namespace setae::tables {

inline constexpr std::string_view first_nanosurf_line = "[DataSet]", last_nanosurf_line = "\n#!";

using TextSection = std::map<std::string, std::string, std::less<>>;
using TextSections = std::map<std::string, TextSection, std::less<>>;

/// Whether a file begins as a Nanosurf file.
[[nodiscard]] bool is_nanosurf(std::string_view head);

/// The value of a key; empty if it is missing.
[[nodiscard]] std::string text_entry(const TextSection& section, std::string_view key);

/// The sections of a header as nanosurf_head() gives it.
[[nodiscard]] TextSections nanosurf_sections(const std::string& head);

/// The header up to "#!". @throws FormatError if there is none.
[[nodiscard]] std::string nanosurf_head(const bytes::Source& source);

/// "Gr0-Ch12" and the name of the section of that channel.
struct NanosurfChannel {
    std::uint32_t group = 0, channel = 0;
    std::string section;
};

/// The channels in a header, in the order of their numbers in the file. @throws FormatError for more than 1000.
[[nodiscard]] std::vector<NanosurfChannel> nanosurf_channels(const TextSections& sections, const bytes::Source& source);

/// Storage of the integers of a channel, and their values.
struct NanosurfIntegers {
    int bits = 0;  ///< 8, 16 or 32
    bool is_signed = false;
    bool big_endian = false;
    std::uint64_t points = 0, lines = 0;
    double factor = 0.0, offset = 0.0;  ///< value = factor · integer + offset, in Dim2Unit

    [[nodiscard]] std::uint64_t bytes() const { return points * lines * static_cast<std::uint64_t>(bits / 8); }
};

/// @throws FormatError "Nanosurf: …" for a section with other or incomplete information.
[[nodiscard]] NanosurfIntegers nanosurf_integers(const TextSection& section, const bytes::Source& source);

}  // namespace setae::tables
