// SPDX-License-Identifier: GPL-3.0-or-later
#include <string_view>
#include <utility>

#include "embedded_archive.hpp"
#include "format_list.hpp"
#include "oir.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"

// Olympus POIR: a ZIP archive of OIR files, usually one of the laser and one of the camera.
namespace setae::formats {
namespace {

bool is_oir(const std::string& member) { return bytes::lowered(member).ends_with(".oir"); }

Match detect_poir(std::string_view head, const bytes::Source& source) {
    if (!bytes::is_zip(head)) return Match::no;
    for (const auto& member : bytes::Archive(source).names())
        if (is_oir(member)) return Match::yes;
    return Match::no;
}

std::vector<Channel> open_poir(const bytes::Source& source, const ReadOptions& options) {
    std::vector<Channel> channels;
    const bytes::Archive archive(source);
    for (const auto& member : archive.names()) {
        if (!is_oir(member)) continue;
        for (auto& channel :
             member_channels(source, member, member.substr(member.rfind('/') + 1), "poir", open_oir, options))
            channels.push_back(std::move(channel));
    }
    return channels;
}

}  // namespace

Format poir_format() {
    return {.identifier = "poir",
            .name = "Olympus POIR",
            .extensions = ".poir",
            .description = "archives of OIR files of Olympus' laser scanning microscopes",
            .heights = "as in each OIR file",
            .orientation = "rows stored from the top",
            .not_read = "what else the archive holds is left out",
            .reference = "Gwyddion's oirfile.c and SurfaceTopography 1.27",
            .detect = detect_poir,
            .open = open_poir};
}

}  // namespace setae::formats
