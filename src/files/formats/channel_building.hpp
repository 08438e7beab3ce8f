// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::formats {

/// A channel that holds a measurement already in memory.
[[nodiscard]] Channel loaded_channel(ChannelInfo info, topography::Measurement measurement);

/// Lets `read` read the heights of a channel from now on, which changes or checks what the old one gave: only as a
/// whole.
void read_as_a_whole(Channel& channel, std::function<topography::Measurement()> read);

/// A channel of something other than heights: listed, never read. `reason`: why, where name and unit do not say it.
[[nodiscard]] Channel non_height_channel(ChannelInfo info, const std::string& reason = {});

/// A channel that does not look like heights: listed with the reason, and read only where somebody chooses it.
[[nodiscard]] Channel doubtful_channel(Channel channel, const std::string& reason);

/// A channel of a member that cannot be opened, for others not to be lost with it: it has the alert UNREADABLE_MEMBER,
/// and its `read` throws again the error that is handled now, whose text is `reason`.
[[nodiscard]] Channel unreadable_member(const bytes::Source& source, const std::string& name,
                                        const std::string& reason);

/// Extent [m] as ChannelInfo::size has it.
[[nodiscard]] std::vector<double> extent(const topography::Measurement& measurement);

/// Shape as ChannelInfo::shape has it.
[[nodiscard]] std::vector<Index> channel_shape(const topography::Measurement& measurement);

/// What every reader owes its caller, of heights that are not infinite.
/// @throws UndefinedDataError where no height is defined; FormatError for fewer than two points or an extent that is no
/// positive length.
void require_measurement(const topography::Measurement& measurement, const bytes::Source& source);

/// The measurement with infinite heights made undefined. @throws as require_measurement.
[[nodiscard]] topography::Measurement checked(topography::Measurement measurement, const bytes::Source& source);

/// A length unit in setae's spelling (m, cm, mm, µm, nm, Å, pm; others as they are) and its factor to metres.
struct LengthUnit {
    std::string name;
    double factor = 1.0;
};

/// The unit the file or the user names. @throws FormatError for a unit that is no length.
[[nodiscard]] LengthUnit length_unit(const std::string& unit, const bytes::Source& source);

/// Standard errors [m] of a column. @throws FormatError without a unit of length or for a value that is negative or
/// undefined.
[[nodiscard]] Array1D standard_errors(const tables::RawTable::RawColumn& column, const bytes::Source& source);

/// Units the user gave, for positions and for heights; empty where none. One unit counts for both, "mm, um" for each
/// its own.
struct GivenUnits {
    std::string positions, heights;
};
[[nodiscard]] GivenUnits given_units(const ReadOptions& options);

/// Fills size and unit that the file leaves open from what the user gave, makes the unit setae's spelling, and copies
/// name, format, unit and, where the metadata names no file, the source's name to the metadata. `info.shape` tells how
/// many sizes belong to it. Returns metres per unit where the unit is the user's, else 1.
/// @throws InvalidArgument for sizes of another number than dimensions; FormatError for a size that is no positive
/// length or a unit that is none.
double complete(ChannelInfo& info, const ReadOptions& options, const bytes::Source& source);

/// A channel that lacks size or unit: listed, and `read` throws InvalidArgument that tells what to give.
[[nodiscard]] Channel incomplete_channel(ChannelInfo info, const bytes::Source& source);

/// A channel whose unit alone nobody says: listed, `read` throws InvalidArgument that asks for it.
[[nodiscard]] Channel channel_without_unit(ChannelInfo info, const bytes::Source& source);

}  // namespace setae::formats
