// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/formats/channel.hpp"
#include "setae/formats/container.hpp"

namespace setae::formats {

/// A container to be written: its index and its members.
struct ContainerDraft {
    Container container;
    std::vector<ContainerMember> members;
    std::vector<Alert> alerts;
};

/// A measured file for a container, and metadata that it lacks.
struct StoredMeasurement {
    std::string path;
    ReadOptions options;
    ChannelChoice channel;                                ///< default: the preferred channel
    std::optional<topography::Trend> trend;               ///< trend in the index: mean (the default), tilt or parabola
    topography::Instrument instrument;                    ///< instrument data not in the file
    std::string height_calibration, lateral_calibration;  ///< ratio of true to stated value, "1.00 ± 0.02"; empty: none
};

/// Adds a measured file to a surface: the file itself, byte for byte, and its processed copy, heights minus their trend
/// as classic NetCDF. If SurfaceTopography does not open the file (Format::read_elsewhere), the original in the index
/// is a member that it opens, two columns x and h or classic NetCDF, and the file is its `source`. The file is read
/// once here to refuse unreadable files, and again when the container is written. @throws as open() and read();
/// InvalidArgument for a file without heights, a missing size or unit, a trend not defined in containers, or a unit not
/// defined in containers if the numbers of the file depend on it.
void add_measurement(ContainerDraft& draft, ContainerSurface& surface, const StoredMeasurement& measurement);

/// Adds the surfaces of a container with all its members. Measurements without a processed copy get one unless they are
/// filled; a scale that the original contains is removed from the index (SCALE_TWICE); size and unit are added if only
/// the file contains them. Unreadable measurements are kept unchanged, with the warning UNREADABLE_MEMBER.
/// @throws as read_container.
void add_container(ContainerDraft& draft, const bytes::Source& source);

/// Adds the measurements of the container `measurement.path` to a surface, or the one chosen by `measurement.channel`,
/// as add_container does for surfaces; given trend and instrument replace those of the container.
/// @throws as read_container; InvalidArgument if it has no such measurement.
void add_measurements_of(ContainerDraft& draft, ContainerSurface& surface, const StoredMeasurement& measurement);

/// Content of a container, its problems, and whether writing and reading reproduce it.
struct ContainerReport {
    ContainerFile file;
    std::vector<ChannelInfo> channels;     ///< one per measurement, in order
    std::vector<Alert> alerts;             ///< of the index, its schema and each measurement
    std::vector<std::string> differences;  ///< between the container and the one that setae writes from it
};

/// Reads all content including heights: SCALE_TWICE, UNREADABLE_MEMBER, ORIGINAL_MISSING, COPY_DIFFERS (original and
/// processed copy do not agree), SIZE_MISMATCH, UNIT_MISMATCH, NOT_IN_SCHEMA, UNKNOWN_FIELD, MALFORMED_FIELD. The
/// container is written to the folder of temporary files and read again.
/// @throws as read_container; FileError if that folder cannot be written.
[[nodiscard]] ContainerReport check_container(const bytes::Source& source);

}  // namespace setae::formats
