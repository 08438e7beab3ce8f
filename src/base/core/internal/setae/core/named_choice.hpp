// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace setae {

/// The index, from 0, of one of several things chosen by name: channels, images, curves of a file.
///
/// An integer is the index. Other text is a name, regardless of case: a whole name first, then an unambiguous
/// beginning.
/// thing: the word for one of them in messages, such as "channel".
/// @throws InvalidArgument that lists numbers and names: for a number beyond the last, an unknown name, and an
/// ambiguous name.
[[nodiscard]] std::size_t chosen_by_name(std::string_view wanted, std::span<const std::string> names,
                                         std::string_view thing);

/// "0 'Height (trace)', 1 'Height (retrace)'": numbers and names for messages; only the first ones of a long list.
[[nodiscard]] std::string numbered_names(std::span<const std::string> names);

}  // namespace setae
