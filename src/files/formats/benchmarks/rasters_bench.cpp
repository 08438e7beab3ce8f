// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <fcntl.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sample_files.hpp"
#include "storage/raster.hpp"

// Heights of 512 MB files in the page cache, compared with the minimum for the same bytes: a read() of the file into
// new memory, new memory of the size of the heights touched once, and a copy of the heights. Peaks and CPU time are
// those of the process.
using namespace setae::tests;

namespace setae::formats {
namespace {

constexpr std::uint64_t file_bytes = std::uint64_t{1} << 29;
constexpr Index columns = 16384;

/// A file of numbers that are heights for every sample type, created once per program.
const std::string& file_path() {
    static const tests::TemporaryFolder folder;
    static const std::string path = [] {
        std::vector<std::uint16_t> block(1 << 20);
        for (std::size_t i = 0; i < block.size(); ++i) block[i] = static_cast<std::uint16_t>(0x3c00u + i % 997);
        auto name = folder.path("heights.raw");
        std::ofstream file(name, std::ios::binary);
        for (std::uint64_t written = 0; written < file_bytes; written += 2 * block.size())
            file.write(reinterpret_cast<const char*>(block.data()), static_cast<std::streamsize>(2 * block.size()));
        if (!file.flush()) throw std::runtime_error("no room for the file of the benchmark");
        return name;
    }();
    return path;
}

/// A number of /proc/self/status in kB.
double status_number(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key + ":")) return std::stod(line.substr(key.size() + 1));
    return 0.0;
}

/// Additional memory that `work` uses at its peak [bytes].
template <class Work>
double peak_of(Work work) {
    std::ofstream("/proc/self/clear_refs") << 5 << std::flush;
    const double before = status_number("VmRSS");
    work();
    return 1024.0 * (status_number("VmHWM") - before);
}

Raster raster_of(Sample sample, bool by_columns, Index width) {
    const auto points = static_cast<Index>(file_bytes / bytes_of(sample));
    Raster raster{.nx = width, .ny = points / width, .sample = sample, .columns = by_columns};
    if (!by_columns) raster.bottom_up = true;
    return raster;
}

void heights(benchmark::State& state, Sample sample, bool by_columns = false, Index width = columns) {
    const auto source = bytes::file_source(file_path());
    const auto raster = raster_of(sample, by_columns, width);
    const double bytes = 8.0 * static_cast<double>(raster.nx) * static_cast<double>(raster.ny);
    state.counters["peak/heights"] =
        peak_of([&] { benchmark::DoNotOptimize(read_raster(source, raster, {.factor = 1e-9})); }) / bytes;
    for (auto _ : state) benchmark::DoNotOptimize(read_raster(source, raster, {.factor = 1e-9}));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file_bytes));
}

/// Reading with the reader of a format, including the checks of every measurement.
void channel(benchmark::State& state, Sample sample) {
    const auto raster = raster_of(sample, false, columns);
    const auto one = raster_channel({.name = "heights", .format = "raw", .size = {1e-3, 1e-3}, .unit = "m"},
                                    bytes::file_source(file_path()), raster, {.factor = 1e-9});
    const double bytes = 8.0 * static_cast<double>(raster.nx) * static_cast<double>(raster.ny);
    state.counters["peak/heights"] = peak_of([&] { benchmark::DoNotOptimize(one.read()); }) / bytes;
    for (auto _ : state) benchmark::DoNotOptimize(one.read());
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file_bytes));
}

void bare_read(benchmark::State& state) {
    const int file = ::open(file_path().c_str(), O_RDONLY | O_CLOEXEC);
    for (auto _ : state) {
        const std::unique_ptr<char[]> memory(new char[file_bytes]);
        for (std::uint64_t at = 0; at < file_bytes;) {
            const auto got = ::pread(file, memory.get() + at, file_bytes - at, static_cast<off_t>(at));
            if (got <= 0) throw std::runtime_error("the file of the benchmark cannot be read");
            at += static_cast<std::uint64_t>(got);
        }
        benchmark::DoNotOptimize(memory[0]);
        benchmark::ClobberMemory();
    }
    ::close(file);
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file_bytes));
}

/// Bytes are those of the file of the heights, with 4 bytes per sample.
void fresh_memory(benchmark::State& state) {
    for (auto _ : state) {
        const std::unique_ptr<double[]> memory(new double[file_bytes / 4]);
        std::memset(memory.get(), 1, 2 * file_bytes);
        benchmark::DoNotOptimize(memory[0]);
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file_bytes));
}

void copied_heights(benchmark::State& state) {
    std::vector<double> from(file_bytes / 4, 1.0), to(file_bytes / 4);
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), 2 * file_bytes);
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file_bytes));
}

BENCHMARK(bare_read)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(fresh_memory)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(copied_heights)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(heights, float32, Sample::float32)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(heights, float64, Sample::float64)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(heights, int16, Sample::int16)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(heights, int32, Sample::int32)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(channel, float32, Sample::float32)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(channel, int16, Sample::int16)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(heights, float32_odd_width, Sample::float32, false, 11587)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(heights, float32_by_columns, Sample::float32, true)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace setae::formats
