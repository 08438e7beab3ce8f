// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::cli {

/// An input file and its output file.
struct Job {
    std::string input, output;
};

/// Outputs with the names of the inputs and another ending, such as "x3p" or ".x3p", in a folder that is created.
/// @throws InvalidArgument for an ending of no format of heights; FileError if the folder cannot be created.
[[nodiscard]] std::vector<Job> jobs_into_folder(const std::vector<std::string>& inputs, const std::string& folder,
                                                const std::string& ending);

/// @throws InvalidArgument if the output of a job is its input or the output of an earlier job.
void require_own_output(const std::vector<Job>& jobs, std::size_t index);

}  // namespace setae::cli
