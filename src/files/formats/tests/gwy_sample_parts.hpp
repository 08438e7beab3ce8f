// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/arrays.hpp"

/// Pieces of Gwyddion files, put together as its user guide describes them.
namespace setae::formats::tests {

[[nodiscard]] std::string gwy_object(const std::string& type, const std::string& components);
[[nodiscard]] std::string gwy_component(const std::string& name, char type, const std::string& value);
[[nodiscard]] std::string gwy_text(const std::string& name, const std::string& value);
[[nodiscard]] std::string gwy_field(const Array2D& heights, double x_real, double y_real, const std::string& unit_xy,
                                    const std::string& unit_z);
[[nodiscard]] std::string gwy_file(const std::string& components);

}  // namespace setae::formats::tests
