// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace setae {

/// The place, from 0, of one of several things that a user names: channels, images, curves of a file.
///
/// A whole number is the place itself. Other text is a name without regard to case: a whole name first, then a
/// beginning that no other name has.
/// thing: the word for one of them in messages, such as "channel".
/// @throws InvalidArgument that lists numbers and names: for a number beyond the last, a name that none has, and one
/// that several have.
[[nodiscard]] std::size_t chosen_by_name(std::string_view wanted, std::span<const std::string> names,
                                         std::string_view thing);

/// "0 'Height (trace)', 1 'Height (retrace)'": numbers and names for messages; of many the first ones.
[[nodiscard]] std::string numbered_names(std::span<const std::string> names);

}  // namespace setae
