// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/constants.hpp"
#include "setae/fields/option.hpp"
#include "setae/formats/channel.hpp"
#include "setae/study/file_content.hpp"

namespace setae::answers {

/// Statistics of the heights of a channel, or the reason for which they could not be read.
struct HeightSummary {
    bool read = false;
    Index undefined_count = 0, points = 0;
    double mean = undefined, standard_deviation = undefined, least = undefined, greatest = undefined;
    std::string error;
    std::vector<Alert> alerts = {};  ///< warnings

    [[nodiscard]] double undefined_share() const {
        return read ? static_cast<double>(undefined_count) / static_cast<double>(points) : undefined;
    }
};

/// Whether a channel's heights can be read as they are: its size and unit are known.
[[nodiscard]] bool can_be_read(const formats::ChannelInfo& info);

/// A channel of a listed file.
struct ListedChannel {
    std::size_t index = 0;
    formats::ChannelInfo info;
    HeightSummary heights;
};

/// A file as `setae info` lists it.
struct ListedFile {
    study::FileContent content;
    std::vector<ListedChannel> channels;  ///< for topographies and containers, the channels shown
    std::uint64_t bytes = 0;
    bool too_large = false;  ///< whether heights are too large to be read without a request
};

/// Request of contents of files.
struct ContentsRequest {
    std::vector<std::string> paths;  ///< files, or folders of them
    study::FileQuestions questions;
    formats::ChannelChoice channel;  ///< the only one that is shown
    bool heights = false, no_heights = false;
};

/// Contents and problems.
struct Contents {
    std::vector<ListedFile> files;
    std::vector<study::UnreadablePath> failed;  ///< files without a result
    std::vector<std::string> own;               ///< files of folders that setae wrote: figures, tables, reports
};

/// @throws InvalidArgument for contradicting questions, and where there is no path.
[[nodiscard]] Contents contents(const ContentsRequest& request);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::ContentsRequest> {
    using R = answers::ContentsRequest;
    static constexpr std::array options{
        option<&R::heights>("heights", "heights of files above 64 MB are read, too"),
        option<&R::no_heights>("no_heights", "only headers are read, no heights"),
    };
};
