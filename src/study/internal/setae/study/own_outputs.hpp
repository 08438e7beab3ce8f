// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace setae::study {

/// The list of its files in a folder of results.
inline constexpr const char* result_list = "files.txt";
/// How that list begins.
inline constexpr std::string_view result_list_heading =
    "# setae: files of this study's results; the next run replaces and removes these alone\n";

/// Whether setae wrote a file that is no measurement, loop or study: a figure (.svg, .pdf, .png, its numbers), an
/// overlay, a table of fits, energies, functions of scale or predictions, JSON of a result, a report. What it wrote as
/// data (levelled heights, traced contours, loop files, contact radii) is none.
[[nodiscard]] bool is_own_output(const std::string& file);

/// The files below a folder of results that its list names, the list among them; empty for other folders. Results of
/// releases without a list are told by study.json and report.html beside each other: then all files below.
[[nodiscard]] std::set<std::string> results_in(const std::string& folder);

}  // namespace setae::study
