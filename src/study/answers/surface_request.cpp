// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/surface_request.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "setae/answers/words.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/study/pipeline_file.hpp"
#include "setae/tables/power_spectrum_table.hpp"

namespace setae::answers {
std::vector<double> lengths_of(const std::string& text) {
    const auto length = [](const std::string& of) {
        const double value = parse_quantity(of, dimension::length);
        if (!(value > 0.0))
            throw InvalidArgument(fmt::format("a size of '{}', expected a length above 0, as in \"1 mm x 1 mm\"", of));
        return value;
    };
    std::vector<double> lengths;
    std::string rest = text;
    for (std::size_t at = rest.find(" x "); at != std::string::npos; at = rest.find(" x ")) {
        lengths.push_back(length(rest.substr(0, at)));
        rest = rest.substr(at + 3);
    }
    lengths.push_back(length(rest));
    if (lengths.size() > 2)
        throw InvalidArgument(
            fmt::format("'{}' has {} lengths; expected \"1 mm x 1 mm\" or \"2 mm\"", text, lengths.size()));
    return lengths;
}

formats::ReadOptions FileRequest::read_options() const {
    formats::ReadOptions options;
    if (!unit.empty()) options.unit = unit;
    if (as == "spectrum")
        throw InvalidArgument(
            "`as = spectrum`: a table of a spectrum holds no heights; setae psd, params, adhesion and "
            "synthesize take it");
    require_word("layout", as, {"matrix", "columns"});
    if (!as.empty()) options.layout = as == "matrix" ? formats::TextLayout::matrix : formats::TextLayout::columns;
    if (!size.empty()) options.size = lengths_of(size);
    options.keep_values = keep_values;
    return options;
}

study::FileQuestions FileRequest::questions() const {
    if (as != "spectrum") return {.heights = read_options()};
    study::FileQuestions questions{.heights = {}, .is_spectrum = true};
    if (!unit.empty()) questions.spectrum = tables::SpectrumUnits::from_text(unit);
    return questions;
}

std::vector<std::string> step_names() {
    std::vector<std::string> names;
    for (const auto& step : processing::step_descriptions()) names.push_back(step.name);
    return names;
}

processing::Pipeline ProcessingRequest::pipeline() const {
    auto pipeline = file.empty() ? processing::Pipeline{} : study::read_pipeline(file);
    for (const auto& step : steps) pipeline.entries.push_back({processing::step_from_text(step)});
    return pipeline;
}

study::MeasurementInput MeasurementRequest::input(const std::string& path) const {
    const auto read = file.read_options();
    require_word("instrument", instrument, fields::Asked<MeasurementRequest>::instruments);
    study::MeasurementInput input;
    input.file = path;
    input.channel = file.channel;
    input.instrument = instrument;
    if (!tip_radius.empty()) input.tip_radius = parse_uncertain_quantity(tip_radius, positive(dimension::length));
    if (!resolution.empty()) input.resolution = parse_quantity(resolution, positive(dimension::length));
    if (!trend.empty()) input.trend = topography::trend_from_name(trend);
    input.unit = read.unit;
    input.size = read.size;
    input.layout = file.as;
    input.keep_values = read.keep_values;
    if (!processing.file.empty()) input.pipeline = processing.file;
    input.steps = study::step_lines(processing.pipeline());
    return input;
}

study::SurfaceAnalysisOptions AnalysisRequest::analysis() const {
    using Asked = fields::Asked<AnalysisRequest>;
    require_word("contours", contours, Asked::contours);
    require_word("conversion", conversion, Asked::conversions);
    if (!(memory > 0.0)) throw InvalidArgument(fmt::format("memory {} GiB; expected more than 0", memory));
    if (resamples < 0) throw InvalidArgument(fmt::format("{} resamples; expected 0 or more", resamples));
    study::SurfaceAnalysisOptions options;
    options.spectrum = study::SpectrumMethod::average;  // these commands show the combined spectrum
    if (!longest.empty()) options.longest_wavelength = parse_uncertain_quantity(longest, positive(dimension::length));
    if (!shortest.empty())
        options.shortest_wavelength = parse_uncertain_quantity(shortest, positive(dimension::length));
    if (!window.empty()) options.window = spectra::window_from_name(window);
    if (contours == "segments") options.contours = spectra::ContourTreatment::segments;
    if (conversion == "eq11") options.conversion = roughness::Conversion::eq11;
    options.largest_map = static_cast<std::uint64_t>(memory * static_cast<double>(std::uint64_t{1} << 30));
    options.bootstrap_resamples = resamples;
    return options;
}

bool SurfaceRequest::is_spectrum() const {
    const auto is_table = [this](const std::string& path) {
        if (file.as == "spectrum") return true;
        try {
            return tables::is_power_spectrum_table(bytes::file_source(path));
        } catch (const FileError&) {  // reading the file later reports the reason, and the others are processed
            return false;
        }
    };
    const auto table = std::find_if(files.begin(), files.end(), is_table);
    if (table == files.end()) return false;
    if (files.size() > 1)
        throw InvalidArgument(
            fmt::format("{}: a table of a spectrum describes a whole surface; give it without the {} other "
                        "files",
                        *table, files.size() - 1));
    return true;
}

study::SurfaceInput SurfaceRequest::surface() const {
    if (files.empty()) throw InvalidArgument("no file; expected at least one measurement");
    study::SurfaceInput surface;
    surface.name = "surface";
    if (is_spectrum()) {
        surface.power_spectrum = files.front();
        if (!file.unit.empty()) surface.spectrum_units = tables::SpectrumUnits::from_text(file.unit);
        return surface;
    }
    for (const auto& path : files) surface.measurements.push_back(input(path));
    return surface;
}

std::vector<Alert> alerts_of(const study::SurfaceResult& surface) {
    std::vector<Alert> alerts;
    for (const auto& m : surface.measurements) alerts.insert(alerts.end(), m.alerts.begin(), m.alerts.end());
    alerts.insert(alerts.end(), surface.alerts.begin(), surface.alerts.end());
    return alerts;
}

}  // namespace setae::answers
