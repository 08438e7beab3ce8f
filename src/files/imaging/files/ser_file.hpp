// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/bytes/source.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// Whether bytes begin as a series of TIA (Emispec).
[[nodiscard]] bool is_ser(std::string_view head);

/// Reads an image of a series; rows are stored from the bottom up, lengths in metres. Untested on real files.
/// @throws as read_micrograph does.
/// Source: C. Boothroyd, "TIA (Emispec) file format" (2006), as openNCEM reads it.
[[nodiscard]] Micrograph read_ser(const bytes::Source& file, const MicrographOptions& options);

/// Adds microscope and time from the EMI of a series: the XML between other bytes. No effect if there is none.
void read_emi(std::string_view emi, Micrograph& micrograph);

/// Name of the EMI of a series: "a.emi" for "a_1.ser".
[[nodiscard]] std::string emi_path(const std::string& ser);

}  // namespace setae::imaging
