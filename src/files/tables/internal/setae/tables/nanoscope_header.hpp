// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "setae/bytes/source.hpp"

/// The header of a Nanoscope file from version 4.3 on: latin-1, sections "\*Name" with lines "\Key: value", from
/// "\*File list" (images) or "\*Force file list" (force curves) to "\*File list end".
namespace setae::tables {

using NanoscopeEntries = std::vector<std::pair<std::string, std::string>>;

/// A section with its entries; its name and keys in lower case, keys without '@' and the group number of "@2:Z scale".
struct NanoscopeSection {
    std::string name;
    NanoscopeEntries entries;
};

/// Whether bytes begin as a Nanoscope file.
[[nodiscard]] bool is_nanoscope(std::string_view head);

/// The sections of a header in their order. @throws FormatError for a header without end.
[[nodiscard]] std::vector<NanoscopeSection> nanoscope_sections(const bytes::Source& source);

/// The value of a key; nullptr if the section has none.
[[nodiscard]] const std::string* find(const NanoscopeSection& section, std::string_view key);
/// The first value of that key outside the sections of images.
[[nodiscard]] const std::string* find(const std::vector<NanoscopeSection>& sections, std::string_view key);
/// The first section of that name; nullptr if there is none.
[[nodiscard]] const NanoscopeSection* section_named(const std::vector<NanoscopeSection>& sections,
                                                    std::string_view name);

/// A positive whole number below 2^40. @throws FormatError for anything else.
[[nodiscard]] std::uint64_t nanoscope_integer(const NanoscopeSection& section, std::string_view key,
                                              const bytes::Source& source);

/// A number and the text after it, such as its unit.
struct NanoscopeValue {
    double number = 0.0;
    std::string unit;
};
[[nodiscard]] std::optional<NanoscopeValue> leading_value(std::string_view text);

/// The parts of "V [Sens. Zsens] (0.005035400 V/LSB) 2.910461 V"; missing parts are empty.
struct NanoscopeScale {
    std::string sensitivity;              ///< "Sens. Zsens"
    std::optional<NanoscopeValue> step;   ///< per stored integer of 16 bits: 0.0050354 "V/LSB"
    std::optional<NanoscopeValue> range;  ///< of all integers: 2.910461 "V"
};
[[nodiscard]] NanoscopeScale nanoscope_scale(const std::string& text);

/// A soft sensitivity such as "V 12.5 nm/V" by its name; empty if the header has none.
[[nodiscard]] std::optional<NanoscopeValue> soft_sensitivity(const std::vector<NanoscopeSection>& sections,
                                                             const std::string& name);

/// A unit in the spelling of setae: degrees are "deg", micrometres "um".
[[nodiscard]] std::string plain_unit(std::string_view unit);

}  // namespace setae::tables
