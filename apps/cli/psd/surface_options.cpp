// SPDX-License-Identifier: GPL-3.0-or-later
#include "psd/surface_options.hpp"

#include <algorithm>

#include "convert/pipeline_option.hpp"
#include "files/file_options.hpp"
#include "program/messages.hpp"
#include "setae/core/units.hpp"

namespace setae::cli {

void SurfaceOptions::add_measurements_to(Options& options, const char* meaning) {
    options.add("files", files, meaning).of_inputs();
    add_file_options(options, file);
    add_processing_options(options, processing);
    options.add("--instrument", instrument, "stylus, afm, tem or optical").one_of({"stylus", "afm", "tem", "optical"});
    options.add("--tip-radius", tip_radius, "such as \"10 ± 2 nm\"; what the tip cannot show is cut")
        .quantity(positive(dimension::length), "nm");
    options.add("--resolution", resolution, "shortest wavelength the instrument shows")
        .quantity(positive(dimension::length), "nm");
    options
        .add(
            "--trend", trend,
            "removed before analysis: none, mean, tilt, parabola; default: none behind a pipeline that levels, else by instrument")
        .offering({"none", "mean", "tilt", "parabola"})
        .read_by([](const std::string& text) { (void)topography::trend_from_name(text); });
    options
        .add("--memory", memory, "GiB of heights held at once, default 2: larger maps are read by bands of scan lines")
        .positive();
}

void SurfaceOptions::add_to(Options& options) {
    add_measurements_to(options, "measurements of one surface: files or containers; or one table of its spectrum");
    options.add("--longest-wavelength", longest, "upper limit of wavelengths in all integrals")
        .quantity(positive(dimension::length));
    options.add("--shortest-wavelength", shortest, "lower limit of wavelengths in all integrals")
        .quantity(positive(dimension::length));
    options.add("--window", window, "automatic, none, hann, blackman_harris")
        .offering({"automatic", "none", "hann", "blackman_harris"})
        .read_by([](const std::string& text) { (void)spectra::window_from_name(text); });
    options.add("--contours", contours, "sinc_corrected or segments").one_of({"sinc_corrected", "segments"});
    options.add("--conversion", conversion, "exact or eq11").one_of({"exact", "eq11"});
    options.add("--bootstrap-resamples", resamples, "replicas behind the standard errors, 0 for none")
        .between(0, 1000000);
}

ExitCode report_failures(const study::SurfaceResult& surface) {
    const auto failed = std::count_if(surface.measurements.begin(), surface.measurements.end(),
                                      [](const auto& m) { return m.failed(); });
    for (const auto& m : surface.measurements)
        if (m.failed()) complain(m.error);
    if (surface.failed()) {
        complain(surface.error);
        return ExitCode::nothing_done;
    }
    return failed > 0 ? ExitCode::some_failed : ExitCode::done;
}

}  // namespace setae::cli
