// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "height_names.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/named_choice.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {
namespace {

/// Whether a name contains the word for the retrace of a scan.
bool is_retrace(const std::string& name) {
    const auto words = words_of_name(name);
    return std::any_of(words.begin(), words.end(), [](const std::string& word) {
        return word == "retrace" || word == "backward" || word == "backwards" || word == "bwd" || word == "back";
    });
}

/// Disadvantages of a channel in order of importance.
std::tuple<bool, bool, bool, bool> drawbacks(const Channel& channel) {
    const auto& info = channel.info;
    return {info.shape.size() < 2, !is_height_name(info.name), info.size.empty() || info.unit.empty(),
            is_retrace(info.name)};
}

/// "none of its 3 channels holds heights: 0 'x' is no heights: values count up by one, …".
std::string without_heights(const std::vector<Channel>& channels) {
    constexpr std::size_t max_reasons = 6;
    auto text = fmt::format("none of its {} channels contains heights", channels.size());
    std::size_t reasons = 0;
    for (std::size_t i = 0; i < channels.size() && reasons < max_reasons; ++i) {
        if (channels[i].info.not_heights.empty()) continue;
        text += fmt::format("{} {} '{}' is not heights: {}", reasons++ == 0 ? ";" : ",", i, channels[i].info.name,
                            channels[i].info.not_heights);
    }
    return reasons == 0 ? text : text + "; to use one of them nevertheless, give `channel`, `size` and `unit`";
}

}  // namespace

std::optional<std::size_t> preferred_channel(const std::vector<Channel>& channels) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < channels.size(); ++i)
        if (channels[i].info.is_height && (!best || drawbacks(channels[i]) < drawbacks(channels[*best]))) best = i;
    return best;
}

std::vector<std::size_t> chosen_channels(const std::string& path, const std::vector<Channel>& channels,
                                         const ChannelChoice& wanted, bool all) {
    if (wanted) {
        std::vector<std::string> names;
        for (const auto& channel : channels) names.push_back(channel.info.name);
        try {
            return {chosen_by_name(*wanted, names, "channel")};
        } catch (const InvalidArgument& error) {
            throw InvalidArgument(fmt::format("{}: {}", path, error.what()));
        }
    }
    std::vector<std::size_t> chosen;
    if (const auto preferred = preferred_channel(channels); preferred && !all) chosen.push_back(*preferred);
    for (std::size_t i = 0; all && i < channels.size(); ++i)
        if (channels[i].info.is_height) chosen.push_back(i);
    if (chosen.empty()) throw InvalidArgument(fmt::format("{}: {}", path, without_heights(channels)));
    return chosen;
}

}  // namespace setae::formats
