// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "sample_files.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/formats/format.hpp"
#include "setae/tables/table_file.hpp"

using namespace setae::tests;

namespace setae::formats {
namespace {

constexpr std::size_t wanted_bytes = 100'000'000;

/// 100 MB of a map of 3000 columns, a file as Gwyddion writes it.
const std::string& matrix_text() {
    static const std::string text = [] {
        std::string made = "# Channel: Z\n# Width: 30 µm\n# Height: 30 µm\n# Value units: m\n";
        made.reserve(wanted_bytes + (1 << 20));
        for (int row = 0; made.size() < wanted_bytes; ++row)
            for (int i = 0; i < 3000; ++i)
                fmt::format_to(std::back_inserter(made), "{:.6g}{}",
                               1e-7 * std::sin(0.01 * i) + 1e-8 * std::cos(0.37 * i * row), i < 2999 ? '\t' : '\n');
        return made;
    }();
    return text;
}

/// A file on disk, read through the cache of the system.
const std::string& matrix_path() {
    static const tests::TemporaryFolder folder;
    static const std::string path = folder.write("matrix.txt", matrix_text());
    return path;
}

void count_bytes(benchmark::State& state, std::size_t bytes) {
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}

void only_copy(benchmark::State& state) {
    const auto& text = matrix_text();
    std::string copy(text.size(), '\0');
    for (auto _ : state) {
        std::memcpy(copy.data(), text.data(), text.size());
        benchmark::ClobberMemory();
    }
    count_bytes(state, text.size());
}

void count_lines_alone(benchmark::State& state) {
    const auto& text = matrix_text();
    for (auto _ : state) {
        std::size_t lines = 0;
        for (const char *at = text.data(), *end = at + text.size();
             (at = static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)))); ++at)
            ++lines;
        benchmark::DoNotOptimize(lines);
    }
    count_bytes(state, text.size());
}

void read_bytes_alone(benchmark::State& state) {
    const auto& path = matrix_path();
    for (auto _ : state) benchmark::DoNotOptimize(bytes::read_file(path));
    count_bytes(state, matrix_text().size());
}

void open_matrix(benchmark::State& state) {
    const auto& path = matrix_path();
    for (auto _ : state) benchmark::DoNotOptimize(open(path));
    count_bytes(state, matrix_text().size());
}

void open_and_read_matrix(benchmark::State& state) {
    const auto& path = matrix_path();
    for (auto _ : state) benchmark::DoNotOptimize(read(path));
    count_bytes(state, matrix_text().size());
}

void write_matrix(benchmark::State& state) {
    const auto map = read(matrix_path());
    const tests::TemporaryFolder folder;
    const auto path = folder.path("written.txt");
    for (auto _ : state) format_to_write(path).write(path, map);
    count_bytes(state, matrix_text().size());
}

/// x, y in two columns, a million lines.
void read_columns(benchmark::State& state) {
    std::string text = "x [um]\th [nm]\n";
    for (int i = 0; i < 1'000'000; ++i)
        fmt::format_to(std::back_inserter(text), "{:.6f}\t{:.6f}\n", 1e-4 * i, 0.01 * (i % 997));
    const auto source = bytes::memory_source("columns", text);
    for (auto _ : state) benchmark::DoNotOptimize(open(source, {}));
    count_bytes(state, text.size());
}

/// x, y, z of a map of 1000 × 1000 points.
void read_points(benchmark::State& state) {
    std::string text = "x [um]\ty [um]\tz [nm]\n";
    for (int i = 0; i < 1000; ++i)
        for (int j = 0; j < 1000; ++j)
            fmt::format_to(std::back_inserter(text), "{:.3f}\t{:.3f}\t{:.6f}\n", 0.01 * i, 0.01 * j,
                           0.01 * ((i * j) % 997));
    const auto source = bytes::memory_source("points", text);
    for (auto _ : state) benchmark::DoNotOptimize(open(source, {}));
    count_bytes(state, text.size());
}

BENCHMARK(only_copy)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(count_lines_alone)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_bytes_alone)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(open_matrix)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(open_and_read_matrix)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(write_matrix)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_columns)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_points)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace setae::formats
