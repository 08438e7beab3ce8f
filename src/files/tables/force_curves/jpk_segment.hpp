// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "jpk_archive.hpp"
#include "setae/tables/force_curve_formats.hpp"

namespace setae::tables {

/// A segment of a force curve of JPK: its properties and those of the archive that it refers to.
class JpkSegment {
public:
    JpkSegment(const JpkArchive& archive, std::string folder);

    /// force-segment-header.KEY, or the value by reference: force-segment-header-info.N.KEY.
    [[nodiscard]] std::optional<std::string> find(const std::string& key) const;
    /// "extend", "pause", "retract".
    [[nodiscard]] std::string style() const;
    /// Height and reading [V]. @throws FormatError naming member and key.
    [[nodiscard]] ForceSegment read() const;
    /// Sensitivity and spring constant from the conversions to "distance" and "force".
    [[nodiscard]] ForceCurveOptions constants() const;
    /// Channel of the height, and its slot.
    [[nodiscard]] std::string height_channel() const;

private:
    struct HeightChannel {
        std::string name, slot;
    };
    /// y = multiplier x + offset.
    struct Scaling {
        double multiplier = 1.0, offset = 0.0;
    };

    [[nodiscard]] std::string member() const { return folder_ + "segment-header.properties"; }
    [[noreturn]] void fail(const std::string& what) const;
    [[nodiscard]] std::optional<std::string> of_channel(const std::string& channel, const std::string& key) const;
    [[nodiscard]] std::string required(const std::string& channel, const std::string& key) const;
    [[nodiscard]] double number(const std::string& text, const std::string& key) const;
    [[nodiscard]] Scaling scaling(const std::string& channel, const std::string& prefix) const;
    [[nodiscard]] bool defines(const std::string& channel, const std::string& slot) const;
    [[nodiscard]] Scaling chain(const std::string& channel, const std::string& slot) const;
    [[nodiscard]] Array1D base_values(const std::string& channel) const;
    [[nodiscard]] Array1D in_slot(const std::string& channel, const std::string& slot) const;
    [[nodiscard]] HeightChannel found_height() const;

    const JpkArchive& archive_;
    std::string folder_;
    Properties own_;
};

}  // namespace setae::tables
