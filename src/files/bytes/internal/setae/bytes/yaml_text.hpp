// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <yaml-cpp/yaml.h>

namespace setae::bytes {

/// The first document of YAML, at most max_levels deep including the targets of its aliases.
///
/// An alias must not refer to a node that contains it, and all aliases together to at most two nodes and sixteen bytes
/// per byte of the text: readers of the document may then follow every alias.
/// @throws FormatError with the line.
[[nodiscard]] YAML::Node parsed_yaml(const std::string& text, const std::string& name);

}  // namespace setae::bytes
