// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::answers {
namespace {

/// Larger files are not read without a request.
constexpr std::uint64_t largest_read = 64'000'000;

HeightSummary summary_of(const Eigen::Ref<const Array1D>& heights) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    HeightSummary summary{.read = true, .undefined_count = heights.isNaN().count(), .points = heights.size()};
    const auto count = static_cast<double>(summary.points - summary.undefined_count);
    const double offset = summary.mean = heights.isNaN().select(0.0, heights).sum() / count;
    summary.standard_deviation = std::sqrt(heights.isNaN().select(0.0, heights - offset).square().sum() / count);
    summary.least = heights.isNaN().select(infinity, heights).minCoeff();
    summary.greatest = heights.isNaN().select(-infinity, heights).maxCoeff();
    return summary;
}

/// Reads the heights of a channel. An error is stated in the result.
HeightSummary summarise(const formats::Channel& channel) {
    try {
        const auto measurement = channel.read();
        auto summary = std::visit(
            [](const auto& m) { return summary_of(Eigen::Map<const Array1D>(m.heights.data(), m.heights.size())); },
            measurement);
        summary.alerts = topography::metadata(measurement).alerts;
        return summary;
    } catch (const std::exception& error) {
        return {.error = reason_of(error)};
    }
}

ListedFile listed(const std::string& file, const ContentsRequest& request) {
    ListedFile listed{.content = study::file_content(file, request.questions),
                      .channels = {},
                      .bytes = bytes::file_source(file).size};
    const bool large = listed.bytes > largest_read;
    const bool wanted = !request.no_heights && (request.heights || !large);
    listed.too_large = large && !request.heights && !request.no_heights;
    const auto& channels = listed.content.channels;
    std::optional<std::size_t> only;
    if (request.channel && !channels.empty()) only = formats::chosen_channels(file, channels, request.channel).front();
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (only && *only != i) continue;
        auto info = channels[i].info;
        auto heights = wanted && can_be_read(info) ? summarise(channels[i]) : HeightSummary{};
        const auto& made = heights.read ? heights.alerts : info.metadata.alerts;
        info.alerts.insert(info.alerts.end(), made.begin(), made.end());
        listed.channels.push_back({i, std::move(info), std::move(heights)});
    }
    return listed;
}

}  // namespace

bool can_be_read(const formats::ChannelInfo& info) {
    return info.is_height && !info.size.empty() && !info.unit.empty();
}

Contents contents(const ContentsRequest& request) {
    if (request.paths.empty()) throw InvalidArgument("no file; expected at least one file or folder");
    if (request.heights && request.no_heights)
        throw InvalidArgument("`heights` and `no_heights` contradict each other; expected one of them");
    const auto found = study::found_files(request.paths);
    Contents contents{.files = {}, .failed = found.unreadable, .own = found.own};
    for (const auto& file : found.files) {
        try {
            contents.files.push_back(listed(file, request));
        } catch (const std::exception& error) {
            contents.failed.push_back({file, reason_of(error, file)});
        }
    }
    return contents;
}

}  // namespace setae::answers
