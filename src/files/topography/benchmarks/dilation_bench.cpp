// SPDX-License-Identifier: GPL-3.0-or-later
// Dilation compared with the plain vectorised maximum over every point of the tip, both in one run.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <benchmark/benchmark.h>

#include "setae/core/constants.hpp"
#include "setae/topography/dilation.hpp"

namespace {

using namespace setae;
using namespace setae::topography;

/// A rough surface: Fourier modes of random phase with amplitudes q^(−1−H) in one direction each, H 0.8.
HeightMap rough_map(Index nx, Index ny, double pixel, double rms, double rolloff, double hurst = 0.8) {
    HeightMap map{Array2D::Zero(nx, ny), {static_cast<double>(nx) * pixel, static_cast<double>(ny) * pixel}, false, {}};
    std::uint64_t state = 1;
    const auto uniform = [&] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state >> 11) * 0x1p-53;
    };
    double variance = 0.0;
    for (int mode = 0; mode < 60; ++mode) {
        const double q = 2.0 * pi / rolloff * std::pow(rolloff / (4.0 * pixel), mode / 60.0);
        const double amplitude = std::pow(q * rolloff, -hurst), angle = 2.0 * pi * uniform(),
                     phase = 2.0 * pi * uniform();
        variance += 0.5 * amplitude * amplitude;
        const Array1D along_x =
            Array1D::LinSpaced(nx, 0.0, static_cast<double>(nx - 1)) * (q * std::cos(angle) * pixel) + phase;
        const Array1D along_y =
            Array1D::LinSpaced(ny, 0.0, static_cast<double>(ny - 1)) * (q * std::sin(angle) * pixel);
        const Array1D cx = amplitude * along_x.cos(), sx = amplitude * along_x.sin(), cy = along_y.cos(),
                      sy = along_y.sin();
        map.heights += (cx.matrix() * cy.matrix().transpose() - sx.matrix() * sy.matrix().transpose()).array();
    }
    map.heights *= rms / std::sqrt(variance);
    return map;
}

// 1024² of an AFM map, 1 nm pixels, with a sphere of 20 nm: 41² pixels
const HeightMap& map() {
    static const HeightMap made = rough_map(1024, 1024, 1e-9, 10e-9, 300e-9);
    return made;
}
const Tip ball = SphereTip{20e-9};

// a stylus strip of 40000 × 400 pixels of 12.5 nm; a sphere of 5 µm reaches 160 pixels over 0.41 µm
const HeightMap& strip() {
    static const HeightMap made = rough_map(40000, 400, 12.5e-9, 60e-9, 2e-6);
    return made;
}
const Tip stylus = SphereTip{5e-6};
constexpr double strip_range = 0.4042e-6;

/// max over all points of the table of the tip, one row of results at a time: the reference time.
void bare_maximum(const ArrayView2D& heights, const TipImage& tip, Array2D& result) {
    const Index ny = heights.cols();
    for (Index i = tip.centre_x; i + tip.centre_x < heights.rows(); ++i) {
        double* out = &result(i, 0);
        for (Index u = 0; u < tip.heights.rows(); ++u)
            for (Index v = 0; v < tip.heights.cols(); ++v) {
                const double t = tip.heights(u, v);
                if (!std::isfinite(t)) continue;
                const double* in = heights.data() + (i + u - tip.centre_x) * ny + v;
                for (Index j = tip.centre_y; j < ny - tip.centre_y; ++j) {
                    const double candidate = in[j - tip.centre_y] - t;
                    out[j] = candidate > out[j] ? candidate : out[j];
                }
            }
    }
}

void bare_maximum_1024_by_41(benchmark::State& state) {
    const auto pixel = map().pixel_size();
    const auto tip = tip_image(ball, pixel[0], pixel[1], 20e-9);
    Array2D result = Array2D::Constant(1024, 1024, -1.0);
    for (auto _ : state) {
        bare_maximum(map().heights, tip, result);
        benchmark::DoNotOptimize(result.data());
    }
    const double comparisons = static_cast<double>((tip.heights < 1.0).count()) * 984.0 * 984.0;
    state.counters["comparisons/s"] = benchmark::Counter(comparisons, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(bare_maximum_1024_by_41)->Unit(benchmark::kMillisecond)->UseRealTime();

void dilated_1024_by_41(benchmark::State& state) {
    const DilationOptions options{.threads = {static_cast<int>(state.range(0))}};
    const HeightMap& surface = map();
    for (auto _ : state) benchmark::DoNotOptimize(dilated(surface, ball, options).heights.data());
}
BENCHMARK(dilated_1024_by_41)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

struct Line {
    Array1D x, y;
};

Line scan_points() { return {Array1D::LinSpaced(5000, 0.0, 499.9e-6), Array1D::Constant(5000, 200 * 12.5e-9)}; }

/// 5000 windows of a disc of 160 pixels radius, one horizontal maximum each.
void bare_maximum_5000_points(benchmark::State& state) {
    const auto& heights = strip().heights;
    const auto tip = tip_image(stylus, 12.5e-9, 12.5e-9, 160 * 12.5e-9);
    double sum = 0.0;
    for (auto _ : state)
        for (Index k = 0; k < 5000; ++k) {
            const Index x = std::clamp<Index>(8 * k, 160, 40000 - 161);
            double lanes[32];
            std::fill(std::begin(lanes), std::end(lanes), -1.0);
            for (Index u = 0; u < 321; ++u) {
                const double* in = &heights(x + u - 160, 40);
                const double* t = &tip.heights(u, 0);
                for (Index v = 0; v < 320; v += 32)
                    for (Index lane = 0; lane < 32; ++lane) {
                        const double candidate = in[v + lane] - t[v + lane];
                        lanes[lane] = candidate > lanes[lane] ? candidate : lanes[lane];
                    }
            }
            sum += *std::max_element(std::begin(lanes), std::end(lanes));
        }
    benchmark::DoNotOptimize(sum);
    state.counters["comparisons/s"] =
        benchmark::Counter(5000.0 * 321.0 * 320.0, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(bare_maximum_5000_points)->Unit(benchmark::kMillisecond)->UseRealTime();

void dilated_at_5000_points(benchmark::State& state) {
    const auto line = scan_points();
    const DilationOptions options{.threads = {static_cast<int>(state.range(0))}, .height_range = strip_range};
    const HeightMap& surface = strip();
    for (auto _ : state) benchmark::DoNotOptimize(dilated_at(surface, stylus, line.x, line.y, options).data());
}
BENCHMARK(dilated_at_5000_points)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// 5000 readings after set-up: a strip read on several lines.
void readings_5000_points(benchmark::State& state) {
    const auto line = scan_points();
    const Dilator dilator(strip(), stylus, {.threads = {1}, .height_range = strip_range});
    for (auto _ : state) benchmark::DoNotOptimize(dilator.readings(line.x, line.y).data());
}
BENCHMARK(readings_5000_points)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
