// SPDX-License-Identifier: GPL-3.0-or-later
#include "measurement_files.hpp"

#include <fmt/format.h>

#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

namespace setae::cli {

std::vector<topography::Measurement> measurements_of(const std::string& path, const FileOptions& options) {
    const auto channels = formats::open(path, options.read_options());
    const bool container = formats::detect_format(bytes::file_source(path)).identifier == "ce-container";
    std::vector<topography::Measurement> found;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const bool wanted =
            options.channel ? *options.channel == i : channels[i].info.is_height && (container || found.empty());
        if (wanted) found.push_back(channels[i].read());
    }
    if (found.empty())
        throw InvalidArgument(options.channel
                                  ? fmt::format("{}: no channel {}, it has {}", path, *options.channel, channels.size())
                                  : fmt::format("{}: none of its {} channels holds heights", path, channels.size()));
    return found;
}

}  // namespace setae::cli
