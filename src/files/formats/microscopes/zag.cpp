// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "format_list.hpp"
#include "profilers/embedded_archive.hpp"
#include "setae/bytes/text.hpp"
#include "setae/bytes/xml_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "zon.hpp"

// Keyence ZAG: same structure as a ZON file; its archive contains an inventory of items; an item of measurements lists
// ZON files.
namespace setae::formats {
namespace {

constexpr const char* zag_name = "ZAG";
constexpr const char* inventory_member = "f1724dc6-686c-4502-9227-2a594bc8ed33";
constexpr const char* zon_member = "84b648d7-e44f-4909-ac11-0476720a67ff";

std::string path_of(const pugi::xml_node& node) {
    std::string path(trimmed(node.child_value("Path")));
    std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}

/// The name of the imported file, otherwise the folder of the measurement.
std::string title_of(const pugi::xml_node& measurement, const std::string& folder) {
    const std::string path(trimmed(measurement.child_value("OriginalFileName")));
    const auto slash = path.find_last_of("/\\");
    const auto file = slash == std::string::npos ? path : path.substr(slash + 1);
    return file.empty() ? folder : file;
}

Match detect_zag(std::string_view head, const bytes::Source& source) {
    if (!is_keyence_package(head)) return Match::no;
    try {
        return bytes::Archive(keyence_archive(source)).has(inventory_member) ? Match::yes : Match::no;
    } catch (const FormatError&) {
        return Match::no;  // detected as ZON, which begins in the same way
    }
}

void add_measurements(std::vector<Channel>& channels, const bytes::Source& inner, const bytes::Archive& archive,
                      const std::string& item, const bytes::Source& source, const ReadOptions& options) {
    const auto document = bytes::parsed_xml(keyence_member(archive, item, source), source, zag_name);
    if (document.document_element().name() != std::string_view("MeasurementDataMap")) return;
    const auto parent = item.substr(0, std::min(item.find('/'), item.size()));
    for (const auto& measurement : document.document_element().children("MeasurementData")) {
        const auto folder = path_of(measurement);
        const bool hidden = bytes::lowered(trimmed(measurement.child_value("Visible"))) == "false";
        for (auto& channel : member_channels(inner, fmt::format("{}/{}/{}", parent, folder, zon_member),
                                             title_of(measurement, folder), "zag", open_zon, options)) {
            if (hidden)
                channel.info.alerts.push_back({"HIDDEN_MEASUREMENT", channel.info.name,
                                               "the file marks this measurement as hidden",
                                               "check whether this measurement belongs to the others"});
            channels.push_back(std::move(channel));
        }
    }
}

std::vector<Channel> open_zag(const bytes::Source& source, const ReadOptions& options) {
    const auto inner = keyence_archive(source);
    const bytes::Archive archive(inner);
    const auto inventory = bytes::parsed_xml(keyence_member(archive, inventory_member, source), source, zag_name);
    std::vector<Channel> channels;
    for (const auto& item : inventory.document_element().children("Item"))
        if (const auto path = path_of(item); !path.empty())
            add_measurements(channels, inner, archive, path, source, options);
    if (channels.empty()) throw FormatError(source.name, {}, "ZAG: no measurement in the inventory");
    return channels;
}

}  // namespace

Format zag_format() {
    return {.identifier = "zag",
            .name = "Keyence ZAG",
            .extensions = ".zag",
            .description = "collections of measurements of Keyence's VR series, each a ZON file and a channel",
            .heights = "as in each ZON file",
            .orientation = "rows stored from the top",
            .not_read = "hidden measurements are channels with a warning; templates and reports are left out",
            .reference = "the inventory as SurfaceTopography 1.27's ZAG reader describes it",
            .detect = detect_zag,
            .open = open_zag};
}

}  // namespace setae::formats
