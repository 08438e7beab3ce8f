// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "setae/study/file_content.hpp"

namespace setae::study {

/// A measurement as a draft lists it.
struct DraftMeasurement {
    std::string file;  ///< as the draft names it
    const formats::ChannelInfo* info;
    std::optional<std::size_t> channel;  ///< where the file has several
    std::string channels;                ///< names of channels, for a remark
};

/// A loop as a draft lists it.
struct DraftLoop {
    std::string file;  ///< as the draft names it
    const FileContent* content;
    std::vector<std::string> mappings{};  ///< that came with setae and read it, where its columns are not known
};

/// The lines above everything.
[[nodiscard]] std::string draft_heading(const std::string& title);
/// "# ---- Surface A ----…".
[[nodiscard]] std::string draft_rule(const std::string& title);
/// `key = "value"` with a remark; both may contain any characters.
[[nodiscard]] std::string draft_line(const std::string& key, const std::string& value, const std::string& remark = "");
/// `# key = "?"` with a remark.
[[nodiscard]] std::string draft_question(const std::string& key, const std::string& remark);
/// A name as a key of TOML.
[[nodiscard]] std::string draft_key(const std::string& name);
/// Text that stays within a comment.
[[nodiscard]] std::string comment_line(const std::string& text);

/// A measurement of a surface with questions for missing values.
[[nodiscard]] std::string measurement_text(const std::string& surface, const DraftMeasurement& measurement);
/// "C1D [m3] from 3.1 nm to 100 µm".
[[nodiscard]] std::string spectrum_remark(const Table& spectrum);
/// The command that traces a micrograph.
[[nodiscard]] std::string contour_command(const std::string& picture, bool ask_pixel_size);
/// The rough solid, elastomers and experiments in comments, with the surfaces that loops may name.
[[nodiscard]] std::string draft_contact(const std::vector<DraftLoop>& loops, const std::vector<std::string>& recordings,
                                        const std::vector<std::string>& surfaces);

}  // namespace setae::study
