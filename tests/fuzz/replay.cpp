// SPDX-License-Identifier: GPL-3.0-or-later
// Calls a fuzz target, compiled without libFuzzer, with every file of a folder and with so many damaged copies of each.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include "fuzz_input.hpp"
#include "setae/bytes/whole_file.hpp"

namespace {

void call(const std::string& content) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(content.data()), content.size());
}

/// A copy with one to four bytes changed, and one in four cut.
std::string damaged(std::string content, std::mt19937& random) {
    constexpr char telling[] = {0, 1, 2, 15, 20, 127, static_cast<char>(128), static_cast<char>(255)};
    if (content.empty()) return content;
    for (auto changes = 1 + random() % 4; changes > 0; --changes)
        content[random() % content.size()] =
            random() % 2 ? telling[random() % sizeof telling] : static_cast<char>(random());
    if (random() % 4 == 0) content.resize(random() % content.size());
    return content;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("usage: replay FOLDER COPIES\n", stderr);
        return 2;
    }
    const auto copies = std::atoi(argv[2]);
    std::mt19937 random(20261122);
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
        const auto content = setae::bytes::read_file(entry.path().string());
        call(content);
        for (int i = 0; i < copies; ++i) call(damaged(content, random));
        ++files;
    }
    std::printf("%d files, %d damaged copies of each\n", files, copies);
    return files > 0 ? 0 : 1;
}
