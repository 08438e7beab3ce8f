// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/temporary_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/platform/files.hpp"

namespace setae::bytes {
namespace {

/// Possible places of temporary folders: $TMPDIR, those of the system, and the working directory.
std::vector<std::string> places_for_temporaries() {
    std::vector<std::string> places;
    if (const char* chosen = std::getenv("TMPDIR"); chosen && *chosen) places.emplace_back(chosen);
    places.insert(places.end(), {"/tmp", "/var/tmp", "."});
    return places;
}

}  // namespace

TemporaryFolder::TemporaryFolder(const std::string& name) {
    std::error_code first_failure;
    const auto places = places_for_temporaries();
    for (const auto& place : places) {
        std::error_code failure;
        path_ = platform::new_folder((std::filesystem::path(place) / ("setae_" + name + "_")).string(), failure);
        if (!failure) return;
        if (!first_failure) first_failure = failure;
    }
    throw FileError(
        fmt::format("{}: no folder for temporary files can be created in it ({}), nor in /tmp, /var/tmp or the "
                    "current folder; set TMPDIR to a folder that is writable and has space",
                    places.front(), first_failure.message()));
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace setae::bytes
