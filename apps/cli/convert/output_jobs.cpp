// SPDX-License-Identifier: GPL-3.0-or-later
#include "convert/output_jobs.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "convert/heights_output.hpp"
#include "setae/bytes/protected_inputs.hpp"
#include "setae/core/errors.hpp"

namespace setae::cli {

namespace fs = std::filesystem;

std::vector<Job> jobs_into_folder(const std::vector<std::string>& inputs, const std::string& folder,
                                  const std::string& ending) {
    const auto whole = ending.starts_with('.') ? ending : "." + ending;
    require_heights_ending("--to " + whole);
    std::vector<Job> jobs;
    for (const auto& input : inputs) {
        bytes::protect_input(input);
        jobs.push_back({input, (fs::path(folder) / fs::path(input).stem()).string() + whole});
    }
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(fmt::format("{}: cannot create this folder; check that no file has this name", folder));
    return jobs;
}

void require_own_output(const std::vector<Job>& jobs, std::size_t index) {
    const auto& job = jobs[index];
    std::error_code missing;
    if (fs::equivalent(job.input, job.output, missing))
        throw InvalidArgument(fmt::format("{}: the output would replace the input; choose another folder", job.input));
    for (std::size_t k = 0; k < index; ++k)
        if (jobs[k].output == job.output)
            throw InvalidArgument(fmt::format("{}: {} is already the output of {}; convert this file separately",
                                              job.input, job.output, jobs[k].input));
}

}  // namespace setae::cli
