// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/protected_inputs.hpp"

#include <sys/stat.h>

#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

/// Device and number on it: the same for every name of a file.
using FileIdentity = std::pair<dev_t, ino_t>;

std::optional<FileIdentity> regular_file(const std::string& path) {
    struct stat found {};
    if (::stat(path.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    return FileIdentity{found.st_dev, found.st_ino};
}

struct Inputs {
    std::mutex mutex;
    int holders = 0;
    std::map<FileIdentity, std::string> paths;
};

Inputs& inputs() {
    static Inputs all;
    return all;
}

}  // namespace

ProtectedInputs::ProtectedInputs() {
    const std::lock_guard lock(inputs().mutex);
    ++inputs().holders;
}

ProtectedInputs::~ProtectedInputs() {
    const std::lock_guard lock(inputs().mutex);
    if (--inputs().holders == 0) inputs().paths.clear();
}

void protect_input(const std::string& path) {
    const auto identity = regular_file(path);
    const std::lock_guard lock(inputs().mutex);
    if (identity && inputs().holders > 0) inputs().paths.emplace(*identity, path);
}

void require_no_input(const std::string& path) {
    const auto identity = regular_file(path);
    if (!identity) return;
    const std::lock_guard lock(inputs().mutex);
    const auto input = inputs().paths.find(*identity);
    if (input == inputs().paths.end()) return;
    // numbers of files that were removed are given to others
    if (regular_file(input->second) != identity) return;
    throw FileError(
        fmt::format("{}: is an input of this run{}, which would be lost; choose another name for the output", path,
                    input->second == path ? "" : " (" + input->second + ")"));
}

}  // namespace setae::bytes
