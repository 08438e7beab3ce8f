// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "sample_files.hpp"
#include "setae/formats/format.hpp"
#include "setae/tables/table_file.hpp"

using namespace setae::tests;

namespace setae::formats {
namespace {

std::string two_columns(int rows, char separator, char decimal) {
    std::string text;
    for (int i = 0; i < rows; ++i) {
        auto line = fmt::format("{:.6f}{}{:.6f}\n", 1e-4 * i, separator, 0.01 * (i % 997));
        for (auto& c : line)
            if (c == '.') c = decimal;
        text += line;
    }
    return text;
}

void read_text(benchmark::State& state, char separator, char decimal) {
    const auto source = bytes::memory_source("text", two_columns(1 << 20, separator, decimal));
    for (auto _ : state) benchmark::DoNotOptimize(tables::read_raw_table(source));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(source.size));
}

void read_nanoscope(benchmark::State& state) {
    const auto n = static_cast<int>(state.range(0));
    const auto source = bytes::memory_source("image", tests::nanoscope_file(n, n, 2));
    const auto channels = open(source, {});
    for (auto _ : state) benchmark::DoNotOptimize(channels.front().read());
    state.SetItemsProcessed(state.iterations() * n * n);
}

void open_container(benchmark::State& state) {
    const auto source = bytes::memory_source("container", tests::container_file());
    for (auto _ : state) benchmark::DoNotOptimize(open(source, {}));
}

BENCHMARK_CAPTURE(read_text, tabs_and_points, '\t', '.')->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_text, semicolons_and_commas, ';', ',')->Unit(benchmark::kMillisecond);
BENCHMARK(read_nanoscope)->Arg(512)->Arg(4096)->Unit(benchmark::kMillisecond);
BENCHMARK(open_container)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace setae::formats
