// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::formats {

/// A channel of a measurement already in memory.
[[nodiscard]] Channel loaded_channel(ChannelInfo info, topography::Measurement measurement);

/// Replaces the `read` of a channel by a function that changes or checks the result of the old one; the channel is then
/// read only as a whole.
void read_as_a_whole(Channel& channel, std::function<topography::Measurement()> read);

/// A channel of a quantity other than height: listed, never read. `reason`: why, if name and unit do not show it.
[[nodiscard]] Channel non_height_channel(ChannelInfo info, const std::string& reason = {});

/// A channel that is unlikely to contain heights: listed with the reason, and read only if the user chooses it.
[[nodiscard]] Channel doubtful_channel(Channel channel, const std::string& reason);

/// A channel for a member that cannot be opened, so the others can be read: it has the warning UNREADABLE_MEMBER, and
/// its `read` throws the currently handled error, whose text is `reason`.
[[nodiscard]] Channel unreadable_member(const bytes::Source& source, const std::string& name,
                                        const std::string& reason);

/// Extent [m] in the form of ChannelInfo::size.
[[nodiscard]] std::vector<double> extent(const topography::Measurement& measurement);

/// Shape in the form of ChannelInfo::shape.
[[nodiscard]] std::vector<Index> channel_shape(const topography::Measurement& measurement);

/// Requirements on every measurement that a reader returns, without infinite heights.
/// @throws UndefinedDataError if no height is defined; FormatError for fewer than two points or an extent that is no
/// positive length.
void require_measurement(const topography::Measurement& measurement, const bytes::Source& source);

/// The measurement with infinite heights set undefined. @throws as require_measurement.
[[nodiscard]] topography::Measurement checked(topography::Measurement measurement, const bytes::Source& source);

/// A length unit in the spelling of setae (m, cm, mm, µm, nm, Å, pm; others as they are) and its factor to metres.
struct LengthUnit {
    std::string name;
    double factor = 1.0;
};

/// The unit given by the file or the user. @throws FormatError for a unit that is no length.
[[nodiscard]] LengthUnit length_unit(const std::string& unit, const bytes::Source& source);

/// Standard errors [m] of a column. @throws FormatError without a unit of length or for a value that is negative or
/// undefined.
[[nodiscard]] Array1D standard_errors(const tables::RawTable::RawColumn& column, const bytes::Source& source);

/// Units given by the user for positions and heights; empty if not given. One unit applies to both; "mm, um" gives both
/// separately.
struct GivenUnits {
    std::string positions, heights;
};
[[nodiscard]] GivenUnits given_units(const ReadOptions& options);

/// Completes missing size and unit of a file with those given by the user, converts the unit to the spelling of setae,
/// and copies name, format, unit and, if the metadata lack the file, the name of the source to the metadata. The number
/// of sizes follows from `info.shape`. @returns metres per unit if the unit is the user's, otherwise 1.
/// @throws InvalidArgument for a wrong number of sizes; FormatError for a size that is no positive length or an invalid
/// unit.
double complete(ChannelInfo& info, const ReadOptions& options, const bytes::Source& source);

/// A channel without size or unit: listed, and `read` throws InvalidArgument with the missing options.
[[nodiscard]] Channel incomplete_channel(ChannelInfo info, const bytes::Source& source);

/// A channel without only the unit: listed, and `read` throws InvalidArgument with the missing option.
[[nodiscard]] Channel channel_without_unit(ChannelInfo info, const bytes::Source& source);

}  // namespace setae::formats
