// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace setae::study {

/// The list of its files in a folder of results.
inline constexpr const char* result_list = "files.txt";
/// First line of that list.
inline constexpr std::string_view result_list_heading =
    "# setae: files of this study's results; the next run replaces and removes these alone\n";

/// Content of the list of a folder of results. Each line contains one name; control characters and the backslash are
/// written as a backslash, x and two hexadecimal digits, so that every name has one line.
struct ResultList {
    std::string study;            ///< study of the results; empty: the list does not state it
    std::set<std::string> names;  ///< files, relative to the folder and inside it

    friend bool operator==(const ResultList&, const ResultList&) = default;
};
[[nodiscard]] ResultList read_result_list(const std::string& path);
/// The study of the results, without the names: from the first lines only.
[[nodiscard]] std::string study_of_result_list(const std::string& path);
[[nodiscard]] std::string as_text(const ResultList& list);
/// One line of the list, which can be appended to it.
[[nodiscard]] std::string result_list_line(const std::string& name);

/// Whether setae wrote a file that is no measurement, loop or study: a figure (.svg, .pdf, .png, its numbers), an
/// overlay, a table of fits, energies, functions of scale or predictions, JSON of a result, a report. Data written by
/// setae (levelled heights, traced contours, loop files, contact radii) are not included.
[[nodiscard]] bool is_own_output(const std::string& file);

/// The files below a folder of results that its list names, including the list; empty for other folders. Results of
/// releases without a list are identified by study.json together with report.html: then all files below.
[[nodiscard]] std::set<std::string> results_in(const std::string& folder);

}  // namespace setae::study
