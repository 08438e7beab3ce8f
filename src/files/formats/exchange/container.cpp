// SPDX-License-Identifier: GPL-3.0-or-later
#include "containers/container_index.hpp"
#include "containers/container_measurement.hpp"
#include "format_list.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/core/errors.hpp"

// Containers of contact.engineering: a ZIP with index.json or, in older ones, meta.yml, and one or two members a
// measurement: the instrument's own file ("original") and a processed copy ("squeezed-netcdf").
namespace setae::formats {
namespace {

Match detect_container(std::string_view head, const bytes::Source& source) {
    return bytes::is_zip(head) && has_index(bytes::Archive(source)) ? Match::yes : Match::no;
}

std::vector<Channel> open_container(const bytes::Source& source, const ReadOptions& options) {
    const bytes::Archive archive(source);
    const auto container = index_content(parsed_index(archive, source)).container;
    std::vector<Channel> channels;
    for (const auto& surface : container.surfaces)
        for (const auto& topography : surface.topographies)
            channels.push_back(container_channel(source, archive, surface, topography, options.keep_values));
    if (channels.empty()) throw FormatError(source.name, {}, "container without measurements");
    return channels;
}

}  // namespace

Format container_format() {
    return {
        .identifier = "ce-container",
        .name = "contact.engineering container",
        .extensions = ".zip",
        .description =
            "ZIP with index.json or meta.yml and one measurement or more, of every generation; the original file is preferred to its processed copy; `setae container write` makes them of any number of files",
        .heights = "as the original file states; the scale of the index is applied only if that file has none",
        .orientation = "as the original file states",
        .not_read =
            "publications, properties and other fields of the index do not change heights; `setae container check` lists them",
        .reference = "SurfaceTopography 1.27.1, Container/IO/Schema.py; TopoBank, manager/container_schema.py",
        .tested_on_real_files = true,
        .carries_scale = true,
        .is_container = true,
        .detect = detect_container,
        .open = open_container};
}

}  // namespace setae::formats
