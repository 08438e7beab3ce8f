// SPDX-License-Identifier: GPL-3.0-or-later
#include "psd/surface_options.hpp"

#include <algorithm>

#include "program/messages.hpp"

namespace setae::cli {

void SurfaceOptions::add_measurements_to(Options& options, const char* meaning) {
    options.add("files", files, meaning).of_inputs();
    options.ask(file, OptionGroup::height_files);
    options.ask(processing);
    options.ask<answers::MeasurementRequest>(*this);
    options.ask(fields::Asked<answers::AnalysisRequest>::memory, static_cast<answers::AnalysisRequest*>(this));
}

void SurfaceOptions::add_to(Options& options) {
    add_measurements_to(options, "measurements of one surface: files or containers; or one table of its spectrum");
    options.ask<answers::AnalysisRequest>(*this);
}

ExitCode report_failures(const study::SurfaceResult& surface) {
    const auto failed = std::count_if(surface.measurements.begin(), surface.measurements.end(),
                                      [](const auto& m) { return m.failed(); });
    for (const auto& m : surface.measurements)
        if (m.failed()) print_message(m.error);
    if (surface.failed()) {
        print_message(surface.error);
        return ExitCode::nothing_done;
    }
    return failed > 0 ? ExitCode::some_failed : ExitCode::done;
}

}  // namespace setae::cli
