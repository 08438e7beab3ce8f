// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/contact/elasticity.hpp"
#include "setae/core/table.hpp"
#include "setae/file_figures/look.hpp"

namespace setae::file_figures {

/// Force against displacement and radius of the contact against force, there and back, a smooth sphere's dashed. table:
/// crack_front::loop_table().
[[nodiscard]] StudyFigure front_figure(const Table& table, const contact::AdhesiveContact& contact,
                                       const std::string& file, const Look& look);

}  // namespace setae::file_figures
