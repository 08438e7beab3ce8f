// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/measurement_files.hpp"

#include "setae/formats/channel.hpp"

namespace setae::cli {

std::vector<topography::Measurement> measurements_of(const std::string& path, const answers::FileRequest& options) {
    std::vector<topography::Measurement> found;
    for (const auto& channel : formats::open_chosen(path, options.channel, options.read_options()))
        found.push_back(channel.read());
    return found;
}

}  // namespace setae::cli
