// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include "rendered_edge.hpp"
#include "setae/imaging/contour_overlay.hpp"
#include "setae/imaging/contour_trace.hpp"

namespace setae::imaging {
namespace {

/// A square picture at twice the noise with an edge of waves of 60 px.
FramePixels picture(long side) {
    return tests::rendered({.width = side, .height = side, .noise = 50},
                           tests::Wave{.level = 0.5 * static_cast<double>(side), .amplitude = 12});
}

/// Minimum work of any tracer: OpenCV smooths the picture.
void opencv_gaussian_blur_alone(benchmark::State& state) {
    const auto pixels = picture(state.range(0));
    const cv::Mat grey(static_cast<int>(pixels.rows()), static_cast<int>(pixels.cols()), CV_32F,
                       const_cast<float*>(pixels.data()));
    cv::Mat smooth;
    for (auto _ : state) cv::GaussianBlur(grey, smooth, {}, 2, 2);
    state.SetItemsProcessed(state.iterations() * pixels.size());
}

void traced_contour(benchmark::State& state) {
    const auto pixels = picture(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(trace_contour(pixels));
    state.SetItemsProcessed(state.iterations() * pixels.size());
}

void anchored_contour(benchmark::State& state) {
    const auto pixels = picture(state.range(0));
    const double side = static_cast<double>(state.range(0));
    const TraceOptions options{.anchors = {{{10, 0.5 * side}, {0.5 * side, 0.5 * side}, {side - 10, 0.5 * side}}}};
    for (auto _ : state) benchmark::DoNotOptimize(trace_contour(pixels, options));
    state.SetItemsProcessed(state.iterations() * pixels.size());
}

void overlay(benchmark::State& state) {
    const auto pixels = picture(state.range(0));
    const auto trace = trace_contour(pixels);
    for (auto _ : state) benchmark::DoNotOptimize(overlay_png(pixels, trace));
    state.SetItemsProcessed(state.iterations() * pixels.size());
}

BENCHMARK(opencv_gaussian_blur_alone)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(traced_contour)->Arg(500)->Arg(1000)->Arg(2000)->Arg(4000)->Unit(benchmark::kMillisecond);
BENCHMARK(anchored_contour)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(overlay)->Arg(2000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace setae::imaging
