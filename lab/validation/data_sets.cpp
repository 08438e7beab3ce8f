// SPDX-License-Identifier: GPL-3.0-or-later
#include "data_sets.hpp"

#include <filesystem>
#include <mutex>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/simulation/data_set.hpp"

namespace setae::validation {

namespace fs = std::filesystem;

void with_data_set(const simulation::Recipe& recipe, const std::string& folder, bool keep,
                   const std::function<void()>& visit) {
    struct Folder {
        const std::string& path;
        bool keep;
        ~Folder() {
            std::error_code ignored;
            if (!keep) fs::remove_all(path, ignored);
        }
    } made{folder, keep};
    simulation::make(recipe, folder, {1});
    visit();
}

study::Study study_of_data_set(const std::string& folder) {
    return study::read_study((fs::path(folder) / "study.toml").string());
}

std::vector<std::string> for_each_data_set(const DataSets& sets, const DataSetVisit& visit) {
    if (sets.runs < 1) throw InvalidArgument(fmt::format("{} runs; expected at least 1", sets.runs));
    (void)simulation::read_recipe(sets.recipe);  // errors are reported once, not once per run
    std::error_code error;
    fs::create_directories(sets.folder, error);
    if (error) throw FileError(fmt::format("{}: cannot make the folder: {}", sets.folder, error.message()));
    std::vector<std::string> failures(static_cast<std::size_t>(sets.runs));
    std::mutex counting;
    int done = 0;
    parallel::for_each_index(failures.size(), sets.threads, [&](std::size_t r) {
        const auto folder = (fs::path(sets.folder) / fmt::format("run_{:04}", r)).string();
        try {
            const auto recipe = simulation::read_recipe(sets.recipe, sets.first_seed + r);
            with_data_set(recipe, folder, sets.keep, [&] { visit(static_cast<int>(r), recipe, folder); });
        } catch (const std::exception& failure) {
            failures[r] = reason_of(failure);
        }
        const std::lock_guard lock(counting);
        ++done;
        if (sets.progress) sets.progress(done);
    });
    return failures;
}

}  // namespace setae::validation
