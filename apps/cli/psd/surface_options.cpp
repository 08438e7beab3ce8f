// SPDX-License-Identifier: GPL-3.0-or-later
#include "psd/surface_options.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "program/messages.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/study/pipeline_file.hpp"
#include "setae/tables/power_spectrum_table.hpp"

namespace setae::cli {

void SurfaceOptions::add_measurements_to(Options& options, const char* meaning) {
    options.add("files", files, meaning).of_inputs();
    file.add_to(options);
    processing.add_to(options);
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

bool SurfaceOptions::is_spectrum() const {
    const auto is_table = [this](const std::string& path) {
        if (file.as == "spectrum") return true;
        try {
            return tables::is_power_spectrum_table(bytes::file_source(path));
        } catch (const FileError&) {  // whoever reads it says why, and the others are done
            return false;
        }
    };
    const auto table = std::find_if(files.begin(), files.end(), is_table);
    if (table == files.end()) return false;
    if (files.size() > 1)
        throw InvalidArgument(
            fmt::format("{}: a table of a spectrum stands for a whole surface; give it alone, without the {} other "
                        "files",
                        *table, files.size() - 1));
    return true;
}

study::SurfaceInput SurfaceOptions::surface() const {
    if (files.empty()) throw InvalidArgument("no file; expected at least one measurement");
    study::SurfaceInput surface;
    surface.name = "surface";
    if (is_spectrum()) {
        surface.power_spectrum = files.front();
        if (!file.unit.empty()) surface.spectrum_units = tables::SpectrumUnits::from_text(file.unit);
        return surface;
    }
    const auto read = file.read_options();
    const auto steps = study::step_lines(processing.pipeline());
    for (const auto& path : files) {
        study::MeasurementInput input;
        input.file = path;
        input.channel = file.channel;
        input.instrument = instrument;
        if (!tip_radius.empty()) input.tip_radius = parse_uncertain_quantity(tip_radius, positive(dimension::length));
        if (!resolution.empty()) input.resolution = parse_quantity(resolution, positive(dimension::length));
        if (!trend.empty()) input.trend = topography::trend_from_name(trend);
        input.unit = read.unit;
        input.size = read.size;
        if (!processing.file.empty()) input.pipeline = processing.file;
        input.steps = steps;
        surface.measurements.push_back(std::move(input));
    }
    return surface;
}

study::SurfaceAnalysisOptions SurfaceOptions::analysis() const {
    study::SurfaceAnalysisOptions options;
    options.spectrum = study::SpectrumMethod::average;  // what these verbs show is the combined spectrum
    if (!longest.empty()) options.limits.longest = parse_quantity(longest, positive(dimension::length));
    if (!shortest.empty()) options.limits.shortest = parse_quantity(shortest, positive(dimension::length));
    if (!window.empty()) options.window = spectra::window_from_name(window);
    if (contours == "segments") options.contours = spectra::ContourTreatment::segments;
    if (conversion == "eq11") options.conversion = roughness::Conversion::eq11;
    options.largest_map = static_cast<std::uint64_t>(memory * static_cast<double>(std::uint64_t{1} << 30));
    options.bootstrap_resamples = resamples;
    return options;
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

std::vector<Alert> alerts_of(const study::SurfaceResult& surface) {
    std::vector<Alert> alerts;
    for (const auto& m : surface.measurements) alerts.insert(alerts.end(), m.alerts.begin(), m.alerts.end());
    alerts.insert(alerts.end(), surface.alerts.begin(), surface.alerts.end());
    return alerts;
}

}  // namespace setae::cli
