// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <yaml-cpp/yaml.h>

namespace setae::bytes {

/// The first document of YAML, at most max_levels deep with what its aliases stand for.
///
/// An alias stands for no node that it is part of, and all of them together for no more than two nodes and sixteen
/// bytes for each byte of the text: what reads the document may follow every one.
/// @throws FormatError with the line.
[[nodiscard]] YAML::Node parsed_yaml(const std::string& text, const std::string& name);

}  // namespace setae::bytes
