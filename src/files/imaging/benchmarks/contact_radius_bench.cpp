// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>

#include "picture_codecs.hpp"
#include "rendered_contact.hpp"
#include "setae/imaging/contact_radius.hpp"

namespace setae::imaging {
namespace {

constexpr int frames = 50;

/// Frames of 640 × 480 with a contact of 100 px at SNR 5, as a stack with LZW, created once.
const std::string& recording() {
    static const std::string path = [] {
        std::vector<cv::Mat> pages;
        const auto pixels = tests::RenderedContact{.width = 640,
                                                   .height = 480,
                                                   .centre_x = 310.2,
                                                   .centre_y = 251.7,
                                                   .semi_major = 100,
                                                   .slope_x = 0.02,
                                                   .noise = 12}
                                .make();
        cv::Mat page;
        cv::Mat(480, 640, CV_32F, const_cast<float*>(pixels.data())).convertTo(page, CV_8U);
        for (int k = 0; k < frames; ++k) pages.push_back(page);
        const auto file = (std::filesystem::temp_directory_path() / "setae_contact_radius_bench.tif").string();
        tests::write_tiff(file, pages);
        return file;
    }();
    return path;
}

void libtiff_decodes_alone(benchmark::State& state) {
    const auto path = recording();
    for (auto _ : state) {
        auto* const tiff = TIFFOpen(path.c_str(), "r");
        std::vector<unsigned char> strip(static_cast<std::size_t>(TIFFStripSize(tiff)));
        do {
            for (std::uint32_t k = 0; k < TIFFNumberOfStrips(tiff); ++k)
                benchmark::DoNotOptimize(TIFFReadEncodedStrip(tiff, k, strip.data(), -1));
        } while (TIFFReadDirectory(tiff));
        TIFFClose(tiff);
    }
    state.SetItemsProcessed(state.iterations() * frames);
}

void source_reads_alone(benchmark::State& state) {
    const FrameSource source(recording(), {.frame_rate = 20});
    for (auto _ : state)
        for (std::size_t k = 0; k < source.size(); ++k) benchmark::DoNotOptimize(source.read(k));
    state.SetItemsProcessed(state.iterations() * frames);
}

void contact_radii(benchmark::State& state) {
    const FrameSource source(recording(), {.pixel_size = 1e-6, .frame_rate = 20});
    for (auto _ : state)
        benchmark::DoNotOptimize(measure_contact_radii(source, {.threads = {static_cast<int>(state.range(0))}}));
    state.SetItemsProcessed(state.iterations() * frames);
}

BENCHMARK(libtiff_decodes_alone)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(source_reads_alone)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(contact_radii)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace setae::imaging
