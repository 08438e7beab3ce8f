// SPDX-License-Identifier: GPL-3.0-or-later
#include "data_sets.hpp"

#include <filesystem>
#include <mutex>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/simulation/data_set.hpp"

namespace setae::validation {

namespace fs = std::filesystem;

std::vector<RunResult> for_each_data_set(
    const DataSets& sets,
    const std::function<std::vector<Comparison>(int run, const simulation::Recipe& recipe, const std::string& folder)>&
        compare) {
    if (sets.runs < 1) throw InvalidArgument(fmt::format("{} runs; expected at least 1", sets.runs));
    (void)simulation::read_recipe(sets.recipe);  // what is wrong in it is said once, not once a run
    std::error_code error;
    fs::create_directories(sets.folder, error);
    if (error) throw FileError(fmt::format("{}: cannot make the folder: {}", sets.folder, error.message()));
    std::vector<RunResult> results(static_cast<std::size_t>(sets.runs));
    std::mutex counting;
    int done = 0;
    parallel::for_each_index(results.size(), sets.threads, [&](std::size_t r) {
        const auto folder = (fs::path(sets.folder) / fmt::format("run_{:04}", r)).string();
        try {
            const auto recipe = simulation::read_recipe(sets.recipe, sets.first_seed + r);
            simulation::make(recipe, folder, {1});
            results[r].comparisons = compare(static_cast<int>(r), recipe, folder);
        } catch (const std::exception& failure) {
            results[r].failure = reason_of(failure);
        }
        std::error_code ignored;
        if (!sets.keep) fs::remove_all(folder, ignored);
        const std::lock_guard lock(counting);
        ++done;
        if (sets.progress) sets.progress(done);
    });
    return results;
}

}  // namespace setae::validation
