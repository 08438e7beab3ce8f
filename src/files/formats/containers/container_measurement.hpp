// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/bytes/archive.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/container.hpp"

namespace setae::formats {

/// A measurement of a container as a channel, with the heights of the original if it exists, otherwise those of the
/// processed copy. Size, unit and scale of the index are used only if the file lacks them. A measurement that cannot be
/// opened becomes a channel with the warning UNREADABLE_MEMBER. Only the header of the file is read here. keep_values:
/// see ReadOptions.
[[nodiscard]] Channel container_channel(const bytes::Source& source, const bytes::Archive& archive,
                                        const ContainerSurface& surface, const ContainerTopography& topography,
                                        bool keep_values = false);

/// Whether the index repeats a scale that the original contains, so programs that apply both scale its heights twice.
/// False for an original that is missing or of unknown format.
[[nodiscard]] bool repeats_scale(const bytes::Archive& archive, const ContainerTopography& topography);

/// The trend of a detrend_mode of a container; empty for others.
[[nodiscard]] std::optional<topography::Trend> trend_of(const std::string& detrend_mode);

}  // namespace setae::formats
