// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/formats/channel.hpp"
#include "setae/formats/container.hpp"

namespace setae::formats {

/// A container in the making: what its index will say and the members it will hold.
struct ContainerDraft {
    Container container;
    std::vector<ContainerMember> members;
    std::vector<Alert> alerts;
};

/// A measured file that is to go into a container, and what it does not say itself.
struct StoredMeasurement {
    std::string path;
    ReadOptions options;
    ChannelChoice channel;  ///< default: the preferred one
    std::optional<topography::Trend>
        trend;                          ///< what the container says to remove: mean (the default), tilt or parabola
    topography::Instrument instrument;  ///< what is known of it beside the file
    std::string height_calibration, lateral_calibration;  ///< true over stated, "1.00 ± 0.02"; empty: none
};

/// Adds a measured file to a surface: the file itself, byte for byte, and its processed copy, heights less their trend
/// as classic NetCDF. Where the field's Python package does not open the file (Format::read_elsewhere), the index's
/// original is a member it does open, two columns x and h or classic NetCDF, and the file is its `source`. The file is
/// read once here, so that what cannot be read is refused, and again when the container is written.
/// @throws as open() and read(); InvalidArgument for a file without heights, a missing size or unit, a trend no
/// container knows, a unit no container knows where the file's numbers rest on it.
void add_measurement(ContainerDraft& draft, ContainerSurface& surface, const StoredMeasurement& measurement);

/// Adds the surfaces of a container with all its members. Measurements without processed copy get one where they are
/// not filled; a scale that the original carries itself is taken out of the index (SCALE_TWICE); size and unit are
/// added where only the file says them. What cannot be read is kept as it is, with the alert UNREADABLE_MEMBER.
/// @throws as read_container.
void add_container(ContainerDraft& draft, const bytes::Source& source);

/// Adds the measurements of the container `measurement.path` to a surface, or the one `measurement.channel` names, as
/// add_container does its surfaces; what is given of trend and instrument replaces what the container says.
/// @throws as read_container; InvalidArgument where it has no such measurement.
void add_measurements_of(ContainerDraft& draft, ContainerSurface& surface, const StoredMeasurement& measurement);

/// What is in a container, what is wrong with it, and whether it is the same after writing and reading.
struct ContainerReport {
    ContainerFile file;
    std::vector<ChannelInfo> channels;     ///< one a measurement, in order
    std::vector<Alert> alerts;             ///< of the index, its schema and each measurement
    std::vector<std::string> differences;  ///< between the container and what setae writes of it
};

/// Reads everything there is, heights too: SCALE_TWICE, UNREADABLE_MEMBER, ORIGINAL_MISSING, COPY_DIFFERS (original and
/// processed copy do not agree), SIZE_MISMATCH, UNIT_MISMATCH, NOT_IN_SCHEMA, UNKNOWN_FIELD, MALFORMED_FIELD. The
/// container is written to the folder of temporary files and read again.
/// @throws as read_container; FileError where that folder cannot be written.
[[nodiscard]] ContainerReport check_container(const bytes::Source& source);

}  // namespace setae::formats
