// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/micrograph.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

#include <benchmark/benchmark.h>

#include "micrograph_files.hpp"

namespace setae::imaging {
namespace {

constexpr std::uint64_t side = 2000;

/// A DM4 of 2000² numbers, removed with the program.
class Picture {
public:
    Picture() : path_(std::filesystem::temp_directory_path() / "setae_micrograph_bench.dm4") {
        const tests::DmFile file{
            .version = 4, .pixels = std::string(4 * side * side, '\0'), .dimensions = {side, side}};
        std::ofstream(path_, std::ios::binary) << file.bytes();
    }
    ~Picture() { std::filesystem::remove(path_); }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

const Picture& picture() {
    static const Picture made;
    return made;
}

void read_dm4_of_2000_squared(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(read_micrograph(picture().path()).pixels.data());
}
BENCHMARK(read_dm4_of_2000_squared)->Unit(benchmark::kMillisecond);

void bare_read_of_the_same_file(benchmark::State& state) {
    const auto bytes = std::filesystem::file_size(picture().path());
    for (auto _ : state) {
        std::vector<char> content(bytes);
        std::FILE* file = std::fopen(picture().path().c_str(), "rb");
        if (!file || std::fread(content.data(), 1, content.size(), file) != bytes) state.SkipWithError("cannot read");
        if (file) std::fclose(file);
        benchmark::DoNotOptimize(content.data());
    }
}
BENCHMARK(bare_read_of_the_same_file)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace setae::imaging
