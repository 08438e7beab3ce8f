// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::cli {

/// A file and what it becomes.
struct Job {
    std::string input, output;
};

/// Every file to its name with another ending, such as "x3p" or ".x3p", in a folder, which is made.
/// @throws InvalidArgument for an ending no heights are written with; FileError for what cannot be made a folder.
[[nodiscard]] std::vector<Job> jobs_into_folder(const std::vector<std::string>& inputs, const std::string& folder,
                                                const std::string& ending);

/// @throws InvalidArgument where a job's file would be written over itself, or over what an earlier one was written to.
void require_own_output(const std::vector<Job>& jobs, std::size_t index);

}  // namespace setae::cli
