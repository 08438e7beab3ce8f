// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/bytes/archive.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/container.hpp"

namespace setae::formats {

/// A measurement of a container as a channel, its heights those of the original where that is there, else of the
/// processed copy. What the index says of size, unit and scale counts only where the file itself says nothing; a
/// measurement that cannot be opened becomes a channel with the alert UNREADABLE_MEMBER. Only the file's header is read
/// here. keep_values: as in ReadOptions.
[[nodiscard]] Channel container_channel(const bytes::Source& source, const bytes::Archive& archive,
                                        const ContainerSurface& surface, const ContainerTopography& topography,
                                        bool keep_values = false);

/// Whether the index repeats a scale that the original carries itself, so that programs that apply both scale its
/// heights twice. False for an original that is missing or of unknown format.
[[nodiscard]] bool repeats_scale(const bytes::Archive& archive, const ContainerTopography& topography);

/// The trend that a container's detrend_mode means; nothing for others.
[[nodiscard]] std::optional<topography::Trend> trend_of(const std::string& detrend_mode);

}  // namespace setae::formats
