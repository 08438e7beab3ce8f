// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "foil_alert.hpp"
#include "setae/bytes/expand.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/format.hpp"
#include "setae/numerics/row_blocks.hpp"
#include "setae/study/levelling.hpp"
#include "setae/study/measurement_options.hpp"
#include "setae/study/pipeline_file.hpp"
#include "setae/study/surface_analysis.hpp"
#include "setae/topography/artefact.hpp"
#include "setae/topography/contour.hpp"
#include "setae/topography/line_scans.hpp"

namespace setae::study {
namespace {

/// By the study, else by the contour's file.
std::optional<Estimate> foil_thickness(const MeasurementInput& input, const topography::Metadata& metadata) {
    if (input.foil_thickness) return input.foil_thickness;
    const auto entry = metadata.attributes.find("foil_thickness");
    if (entry == metadata.attributes.end()) return std::nullopt;
    const Estimate thickness = parse_uncertain_quantity(entry->second, dimension::length);
    return thickness.value > 0.0 ? std::optional(thickness) : std::nullopt;
}

void add_projection_alert(PreparedMeasurement& prepared, const MeasurementInput& input) {
    const auto& metadata = topography::metadata(prepared.measurement);
    if (const auto thickness = foil_thickness(input, metadata))
        prepared.alerts.push_back(foil_projection_alert(topography::label(metadata), thickness->value));
}

void apply_instrument(topography::Instrument& instrument, const MeasurementInput& input) {
    if (!input.instrument.empty()) instrument.type = input.instrument;
    if (input.resolution) instrument.resolution = input.resolution;
    if (!input.tip_radius) return;
    instrument.tip_radius = input.tip_radius->value;
    instrument.tip_radius_standard_error.reset();
    if (input.tip_radius->uncertain()) instrument.tip_radius_standard_error = input.tip_radius->standard_error;
}

/// A factor that a container states for its instrument: one input of all its measurements in the container.
std::optional<Estimate> stated_factor(const topography::Metadata& metadata, const char* key, const char* quantity) {
    const auto stated = metadata.attributes.find(key), scope = metadata.attributes.find("instrument_of_container");
    if (stated == metadata.attributes.end() || scope == metadata.attributes.end()) return std::nullopt;
    auto factor = parse_uncertain_quantity(stated->second, positive(dimension::none));
    factor.input = fmt::format("{} of {}", quantity, scope->second);
    if (factor.value != 1.0) factor.input += fmt::format(" ({:.6g})", factor.value);
    return factor;
}

std::string stated_tip(const topography::Metadata& metadata) {
    const auto scope = metadata.attributes.find("instrument_of_container");
    const auto& instrument = metadata.instrument;
    if (scope == metadata.attributes.end() || !instrument.tip_radius_standard_error) return {};
    return fmt::format("tip radius of {} ({})", scope->second, format_value(*instrument.tip_radius, "m", 3));
}

/// Inputs of an instrument from the study, else from the container.
InstrumentInputs inputs_of(const MeasurementInput& input, const topography::Metadata& metadata) {
    InstrumentInputs inputs;
    inputs.tip_radius = input.tip_radius ? input.tip_radius->input : stated_tip(metadata);
    if (input.foil_thickness) inputs.foil_thickness = input.foil_thickness->input;
    const auto take = [&](const std::optional<Estimate>& stated, Estimate& factor, const char* key) {
        if (!stated) return;
        if (!(stated->value > 0.0))
            throw InvalidArgument(fmt::format("{}: {} {}, expected true over stated, a factor > 0 such as 1.00 ± 0.02",
                                              input.file, key, stated->value));
        factor = *stated;
    };
    const auto or_stated = [&](const std::optional<Estimate>& said, const char* key, const char* quantity) {
        return said ? said : stated_factor(metadata, key, quantity);
    };
    take(or_stated(input.height_calibration, "height_calibration", "height calibration"), inputs.height_calibration,
         "height_calibration");
    take(or_stated(input.lateral_calibration, "lateral_calibration", "lateral calibration"), inputs.lateral_calibration,
         "lateral_calibration");
    return inputs;
}

void scale_lengths(topography::Measurement& measurement, double factor) {
    if (auto* map = std::get_if<topography::HeightMap>(&measurement)) {
        for (double& size : map->size) size *= factor;
    } else if (auto* scan = std::get_if<topography::LineScan>(&measurement)) {
        scan->size *= factor;
    } else {
        auto& curve = std::get<topography::Profile>(measurement);
        curve.positions *= factor;
        if (!curve.response) return;
        for (double* length : {&curve.response->blur, &curve.response->smoothing_length, &curve.response->step,
                               &curve.response->noise_density})
            *length *= factor;
    }
}

/// Heights and lengths as they are, of those that the instrument stated.
void calibrate(PreparedMeasurement& prepared) {
    const double height = prepared.inputs.height_calibration.value, lateral = prepared.inputs.lateral_calibration.value;
    if (height != 1.0) prepared.measurement = topography::scaled(std::move(prepared.measurement), height);
    if (lateral == 1.0) return;
    scale_lengths(prepared.measurement, lateral);
    prepared.untouched.band.lower /= lateral;
    prepared.untouched.band.upper /= lateral;
}

/// The same of a map by bands.
void calibrate(topography::TiledMap& map, const InstrumentInputs& inputs) {
    for (double& size : map.size) size *= inputs.lateral_calibration.value;
    const double height = inputs.height_calibration.value;
    if (height != 1.0)
        map.lines = [lines = std::move(map.lines), height](Index first, Index count) -> Array2D {
            return height * lines(first, count);
        };
}

/// Probe of a measurement, where it is no sphere. @throws InvalidArgument for a shape without a size.
std::optional<spectral_fit::Probe> probe_of(const MeasurementInput& input, const topography::Metadata& metadata,
                                            const formats::ReadOptions& options) {
    const auto radius = [&] {
        const auto& instrument = metadata.instrument;
        if (!instrument.tip_radius)
            throw InvalidArgument(
                fmt::format("{}: tip_shape = \"{}\" needs a tip_radius", input.file, input.tip_shape));
        return Estimate{.value = *instrument.tip_radius,
                        .standard_error = instrument.tip_radius_standard_error.value_or(0.0)};
    };
    if (input.tip_file) {
        const auto picture = formats::read(*input.tip_file, std::nullopt, options);
        const auto* map = std::get_if<topography::HeightMap>(&picture);
        if (!map)
            throw InvalidArgument(
                fmt::format("{}: a line does not contain the shape of a tip; expected a map", *input.tip_file));
        return spectral_fit::measured_tip(topography::tip_from_picture(*map), *input.tip_file);
    }
    if (input.tip_shape == "paraboloid") return spectral_fit::paraboloid(radius());
    if (input.tip_shape == "cone") {
        if (!input.tip_half_angle)
            throw InvalidArgument(fmt::format("{}: tip_shape = \"cone\" needs a tip_half_angle", input.file));
        return spectral_fit::cone(radius(), *input.tip_half_angle);
    }
    if (const auto thickness = foil_thickness(input, metadata)) return spectral_fit::foil(*thickness);
    return std::nullopt;
}

std::optional<spectral_fit::OpticalTransfer> optics_of(const MeasurementInput& input) {
    if (input.numerical_aperture.has_value() != input.light_wavelength.has_value())
        throw InvalidArgument(fmt::format("{}: expected numerical_aperture and light_wavelength together", input.file));
    if (!input.numerical_aperture) return std::nullopt;
    if (!(*input.numerical_aperture > 0.0) || !(*input.light_wavelength > 0.0))
        throw InvalidArgument(fmt::format("{}: numerical_aperture {}, light_wavelength {} m; expected both > 0",
                                          input.file, *input.numerical_aperture, *input.light_wavelength));
    return spectral_fit::OpticalTransfer{*input.numerical_aperture, *input.light_wavelength};
}

topography::LineScan subtract_references(const topography::LineScan& scan, const MeasurementInput& input,
                                         const formats::ReadOptions& options) {
    std::vector<topography::LineScan> references;
    for (const auto& file : input.references) {
        const auto measurement = formats::read(file, std::nullopt, options);
        const auto* reference = std::get_if<topography::LineScan>(&measurement);
        if (!reference)
            throw InvalidArgument(
                fmt::format("{}: a reference of a line scan must be a line scan with equal steps", file));
        references.push_back(*reference);
    }
    return topography::subtract_artefact(scan, topography::average_reference(references));
}

/// Parts of the traced curve that levelling left out.
void add_reentrance_alert(PreparedMeasurement& prepared) {
    const auto& metadata = topography::metadata(prepared.measurement);
    const auto entry = metadata.attributes.find("reentrant_share");
    if (entry == metadata.attributes.end()) return;
    const double share = parse_quantity(entry->second, dimension::none);
    if (!(share > 0.0)) return;
    prepared.alerts.push_back(
        {"REENTRANT", topography::label(metadata),
         fmt::format("{:.2g} % of the length of the traced curve lay on overhangs, which a profile h(x) cannot "
                     "contain",
                     100.0 * share),
         "look at the curve; if the share exceeds a few per cent, slope and curvature are lower bounds"});
}

Index undefined_among(const double* heights, Index n) {
    const auto parts =
        numerics::by_row_blocks(numerics::RowBlocks(n, 1), {}, Index{0}, [&](Index first, Index last, Index& count) {
            for (Index k = first; k < last; ++k) count += std::isnan(heights[k]);
        });
    return std::accumulate(parts.begin(), parts.end(), Index{0});
}

/// Replacement of undefined heights in spectra.
void add_gap_alert(PreparedMeasurement& prepared) {
    const auto count = [&](const auto& heights, const topography::Metadata& metadata) {
        const auto missing = undefined_among(heights.data(), heights.size());
        if (missing == 0) return;
        const double share = static_cast<double>(missing) / static_cast<double>(heights.size());
        prepared.alerts.push_back(
            {"UNDEFINED", metadata.file,
             fmt::format(
                 "{} of {} heights ({:.2g} %) are undefined; spectra interpolate the gaps, which the likelihood "
                 "takes into account and the average does not",
                 missing, heights.size(), 100.0 * share),
             "measure again if the gaps are wide"});
    };
    if (const auto* map = std::get_if<topography::HeightMap>(&prepared.measurement)) count(map->heights, map->metadata);
    if (const auto* scan = std::get_if<topography::LineScan>(&prepared.measurement))
        count(scan->heights, scan->metadata);
}

/// Contours become functions of x.
void make_analysable(PreparedMeasurement& prepared) {
    if (const auto* profile = std::get_if<topography::Profile>(&prepared.measurement)) {
        auto cleaned = topography::clean_contour(*profile);
        prepared.alerts.insert(prepared.alerts.end(), cleaned.alerts.begin(), cleaned.alerts.end());
        prepared.measurement = std::move(cleaned.profile);
    }
    add_gap_alert(prepared);
}

LevellingAsked asked_of(const formats::Channel& channel, const MeasurementInput& input,
                        const topography::Metadata& metadata) {
    return {input.trend, channel.info.recommended_trend, metadata.instrument.type};
}

std::optional<TiledMeasurement> tiled_measurement(const formats::Channel& channel, const MeasurementInput& input,
                                                  std::optional<std::size_t> taken) {
    if (!input.steps.empty()) return {};  // steps look at the whole map
    auto map = formats::tiled(channel);
    if (!map) return {};
    apply_instrument(map->metadata.instrument, input);
    const auto trend = trend_after({}, asked_of(channel, input, map->metadata));
    auto inputs = inputs_of(input, map->metadata);
    calibrate(*map, inputs);
    return TiledMeasurement{std::move(*map), trend, channel.info.alerts, std::move(inputs), taken};
}

void process(PreparedMeasurement& prepared, const processing::Pipeline& pipeline, const formats::ReadOptions& options) {
    auto result = processing::apply(pipeline, std::move(prepared.measurement), measurement_loader(options));
    prepared.measurement = std::move(result.measurement);
    for (const auto& record : result.records)
        prepared.alerts.insert(prepared.alerts.end(), record.alerts.begin(), record.alerts.end());
    prepared.processing = std::move(result.records);
}

double step_along_x(const topography::Measurement& measurement) {
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) return map->pixel_size()[0];
    if (const auto* scan = std::get_if<topography::LineScan>(&measurement)) return scan->pixel_size();
    const auto& profile = std::get<topography::Profile>(measurement);
    return profile.size() / static_cast<double>(profile.positions.size() - 1);
}

PreparedMeasurement prepare(const formats::Channel& channel, const MeasurementInput& input,
                            const formats::ReadOptions& options, std::optional<std::size_t> taken) {
    PreparedMeasurement prepared;
    prepared.channel = taken;
    prepared.alerts = channel.info.alerts;
    prepared.direction = input.direction;
    prepared.optics = optics_of(input);
    prepared.measurement = channel.read();
    for (const auto& alert : topography::metadata(prepared.measurement).alerts) prepared.alerts.push_back(alert);
    prepared.inputs = inputs_of(input, topography::metadata(prepared.measurement));
    apply_instrument(topography::metadata(prepared.measurement).instrument, input);
    if (!input.references.empty()) {
        const auto* scan = std::get_if<topography::LineScan>(&prepared.measurement);
        if (!scan)
            throw InvalidArgument(
                fmt::format("{}: references are subtracted from line scans with equal steps only", input.file));
        prepared.measurement = subtract_references(*scan, input, options);
    }
    const auto pipeline = pipeline_of_lines(input.steps);
    prepared.untouched = processing::untouched(pipeline, step_along_x(prepared.measurement));
    process(prepared, pipeline, options);
    calibrate(prepared);
    make_analysable(prepared);
    topography::validate(prepared.measurement);
    prepared.probe = probe_of(input, topography::metadata(prepared.measurement), options);
    add_projection_alert(prepared, input);
    add_reentrance_alert(prepared);
    prepared.trend = trend_after(pipeline, asked_of(channel, input, topography::metadata(prepared.measurement)));
    prepared.measurement = topography::detrended(std::move(prepared.measurement), prepared.trend);
    return prepared;
}

/// "0 'Height (trace)', 1 'Height (retrace)'": the channels of heights.
std::string height_channels(const std::vector<formats::Channel>& channels) {
    std::string list;
    for (std::size_t i = 0; i < channels.size(); ++i)
        if (const auto& info = channels[i].info; info.is_height)
            list += fmt::format("{}{} '{}'", list.empty() ? "" : ", ", i, info.name);
    return list;
}

/// Warning with the channel of heights that was used, of several.
Alert choice_alert(const std::string& file, const std::vector<formats::Channel>& channels, std::size_t taken) {
    return {"CHANNEL_CHOSEN", file,
            fmt::format("channel {} '{}' was used; channels with heights: {}", taken, channels[taken].info.name,
                        height_channels(channels)),
            "choose another channel by number or name in `channel`"};
}

}  // namespace

formats::ReadOptions read_options(const MeasurementInput& input) {
    formats::ReadOptions options{.size = input.size, .unit = input.unit, .keep_values = input.keep_values};
    if (input.layout == "matrix") options.layout = formats::TextLayout::matrix;
    if (input.layout == "columns") options.layout = formats::TextLayout::columns;
    return options;
}

std::vector<MeasurementSource> measurement_sources(const MeasurementInput& input) {
    const auto options = read_options(input);
    if (input.in_memory.read) {
        const formats::Channel channel{.info = {}, .read = input.in_memory.read};
        return {{[channel, input, options] { return prepare(channel, input, options, {}); }, {}}};
    }
    const auto source = bytes::unpacked(bytes::file_source(input.file));
    const auto& format = formats::detect_format(source);
    auto channels = formats::open(source, format, options);
    const bool several =
        std::count_if(channels.begin(), channels.end(), [](const auto& c) { return c.info.is_height; }) > 1;
    std::vector<MeasurementSource> found;
    for (const auto i : formats::chosen_channels(input.file, channels, input.channel, format.is_container)) {
        std::optional<std::size_t> taken;
        if (several && !input.channel && !format.is_container) {
            taken = i;
            channels[i].info.alerts.push_back(choice_alert(input.file, channels, i));
        }
        const auto& channel = channels[i];
        found.push_back({[channel, input, options, taken] { return prepare(channel, input, options, taken); },
                         tiled_measurement(channel, input, taken)});
    }
    return found;
}

}  // namespace setae::study
