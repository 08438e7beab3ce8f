// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/protected_inputs.hpp"

#include <map>
#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/platform/files.hpp"

namespace setae::bytes {
namespace {

using platform::FileIdentity;

std::optional<FileIdentity> regular_file(const std::string& path) {
    const auto facts = platform::facts_of(path);
    if (!facts || facts->kind != platform::FileKind::regular) return std::nullopt;
    return facts->identity;
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
    // file numbers of removed files are reused
    if (regular_file(input->second) != identity) return;
    throw FileError(
        fmt::format("{}: this file is an input of this run{} and would be overwritten; choose another name for the "
                    "output",
                    path, input->second == path ? "" : " (" + input->second + ")"));
}

}  // namespace setae::bytes
