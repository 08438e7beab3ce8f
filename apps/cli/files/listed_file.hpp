// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "files/height_summary.hpp"
#include "setae/output/json.hpp"
#include "setae/study/file_content.hpp"

namespace setae::cli::info_command {

/// A channel of a listed file.
struct ListedChannel {
    std::size_t index = 0;
    formats::ChannelInfo info;
    HeightSummary heights;
};

/// A file as `setae info` lists it.
struct ListedFile {
    study::FileContent content;
    std::vector<ListedChannel> channels;  ///< of topographies and containers, those that are shown
    std::uint64_t bytes = 0;
    bool too_large = false;  ///< for its heights to be read without being asked to
};

/// How much is said of each file. What is left out where little is said is there with more.
enum class Detail { little, usual, all };

/// Files as tables for a terminal of a width: one for each kind, headed by the commands that take such files. Paths
/// are relative to the folder that holds them all, which is named first. Where a table is too wide, names of files give
/// way as long as they can be told, then little is said; at last rows are stacked.
[[nodiscard]] std::string file_tables(const std::vector<ListedFile>& files, Detail detail, std::size_t width);

/// A channel with all that is known of it; null where that is nothing.
[[nodiscard]] output::Json channel_json(const std::string& file, const ListedChannel& channel);

/// A file: its kind, format and verbs, and what its kind has to say.
[[nodiscard]] output::Json file_json(const ListedFile& file);

}  // namespace setae::cli::info_command
