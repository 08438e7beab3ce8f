// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// The files of page/ and Plotly, put into the program when it is built.
namespace setae::report::assets {

extern const std::string_view style;    ///< page/report.css
extern const std::string_view program;  ///< page/report.js
extern const std::string_view plotly;   ///< plotly-cartesian.min.js, MIT licence

}  // namespace setae::report::assets
