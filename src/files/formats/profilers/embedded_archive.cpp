// SPDX-License-Identifier: GPL-3.0-or-later
#include "embedded_archive.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/core/errors.hpp"

namespace setae::formats {

bytes::Source archive_after_picture(const bytes::Source& source, std::uint64_t picture, std::uint64_t picture_bytes,
                                    const std::string& format) {
    constexpr std::uint64_t gap = 1024, signature_bytes = 4;
    const auto begin = picture + picture_bytes;
    if (begin > source.size || source.size - begin < signature_bytes)
        throw FormatError(
            source.name, {.offset = source.size},
            fmt::format("{}: the file ends here, expected its archive at byte {}; it is truncated or damaged", format,
                        begin));
    const std::string window = source.bytes(begin, std::min(gap + signature_bytes, source.size - begin));
    for (std::uint64_t skipped = 0; skipped + signature_bytes <= window.size(); ++skipped)
        if (bytes::is_zip(std::string_view(window).substr(skipped)))
            return bytes::part_of(source, source.name, begin + skipped, source.size - begin - skipped);
    throw FormatError(source.name, {.offset = begin},
                      fmt::format("{}: no ZIP archive follows the picture; the file is damaged", format));
}

std::vector<Channel> member_channels(const bytes::Source& archive, const std::string& member, const std::string& title,
                                     const std::string& format, const OpenFile& open_file, const ReadOptions& options) {
    try {
        auto channels = open_file(bytes::Archive(archive).member(member), options);
        for (std::size_t i = 0; i < channels.size(); ++i) {
            auto& info = channels[i].info;
            info.name = channels.size() > 1 ? fmt::format("{}: {}", title, info.name) : title;
            info.metadata.name = info.name;
            info.format = info.metadata.format = format;
            if (!info.is_height) continue;
            read_as_a_whole(channels[i], [archive, member, metadata = info.metadata, i, open_file, options] {
                auto measurement = open_file(bytes::Archive(archive).member(member), options).at(i).read();
                topography::metadata(measurement) = metadata;
                return measurement;
            });
        }
        return channels;
    } catch (const Error& error) {
        ChannelInfo info{.name = title, .format = format, .is_height = false};
        info.metadata.file = archive.name;
        info.metadata.name = title;
        info.alerts.push_back({"UNREADABLE_MEMBER", title, error.what(),
                               "the other measurements are not affected; repair or replace this one"});
        return {{std::move(info),
                 [error = std::current_exception()]() -> topography::Measurement { std::rethrow_exception(error); }}};
    }
}

}  // namespace setae::formats
