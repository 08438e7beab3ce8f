// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contact_surface.hpp"

#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "setae/answers/words.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/formats/channel.hpp"
#include "setae/processing/seam.hpp"
#include "setae/processing/steps.hpp"
#include "setae/study/levelling.hpp"
#include "setae/study/pipeline_file.hpp"

namespace setae::answers {
namespace {

using processing::PipelineResult;
using topography::Trend;

bool repeats(const topography::Measurement& measurement) {
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) return map->periodic;
    return std::get<topography::LineScan>(measurement).periodic;
}

void make_periodic(topography::Measurement& measurement) {
    if (auto* map = std::get_if<topography::HeightMap>(&measurement)) map->periodic = true;
    else std::get<topography::LineScan>(measurement).periodic = true;
}

std::optional<Trend> given_trend(const MeasuredSurfaceRequest& request) {
    if (request.trend.empty()) return {};
    return topography::trend_from_name(request.trend);
}

void subtract(PipelineResult& surface, Trend trend, parallel::Threads threads) {
    if (trend == Trend::none) return;
    auto levelled = processing::apply({.entries = {{processing::step_named(topography::name(trend))}}},
                                      std::move(surface.measurement), {}, threads);
    surface.measurement = std::move(levelled.measurement);
    surface.records.insert(surface.records.end(), std::make_move_iterator(levelled.records.begin()),
                           std::make_move_iterator(levelled.records.end()));
}

void window(PipelineResult& surface) {
    auto windowed = processing::windowed(std::move(surface.measurement));
    surface.measurement = std::move(windowed.measurement);
    surface.records.push_back(std::move(windowed.record));
}

Alert alert_of(const processing::Seam& seam, const topography::Metadata& metadata) {
    return {
        "MAP_NOT_PERIODIC", topography::label(metadata),
        fmt::format(
            "heights differ by {} (rms) across the periodic boundary of the map, and by {} between neighbouring "
            "points: the periodically repeated map has a step that the surface does not have",
            format_value(seam.height_step, "m", 3), format_value(seam.usual_step, "m", 3)),
        "use `edges = windowed` to remove the step, `edges = free` for contact within the map only, or `edges = periodic` "
        "if the surface is periodic"};
}

}  // namespace

void MeasuredSurfaceRequest::require_valid() const {
    require_word("edges", edges, fields::Asked<MeasuredSurfaceRequest>::edges);
    (void)given_trend(*this);
}

PipelineResult into_contact(PipelineResult read, const processing::Pipeline& pipeline, std::optional<Trend> recommended,
                            const MeasuredSurfaceRequest& request, BeyondMap beyond, parallel::Threads threads) {
    request.require_valid();
    if (std::holds_alternative<topography::Profile>(read.measurement)) return read;
    const auto given = given_trend(request);
    const bool stated = request.edges == "periodic" || repeats(read.measurement);
    const bool closed = stated || processing::seam_of(read.measurement).closed;
    const auto& instrument = topography::metadata(read.measurement).instrument.type;
    subtract(read,
             closed ? given.value_or(Trend::none) : study::trend_after(pipeline, {given, recommended, instrument}),
             threads);
    if (request.edges == "windowed") {
        window(read);
        return read;
    }
    const auto seam = processing::seam_of(read.measurement);
    if (request.edges == "periodic" || seam.closed) make_periodic(read.measurement);
    else if (beyond == BeyondMap::itself && !repeats(read.measurement)) {
        auto& metadata = topography::metadata(read.measurement);
        metadata.alerts.push_back(alert_of(seam, metadata));
    }
    return read;
}

PipelineResult contact_surface(const std::string& path, const FileRequest& file, const processing::Pipeline& pipeline,
                               const ContactSurfaceRequest& request, BeyondMap beyond, parallel::Threads threads) {
    request.measured.require_valid();
    if (is_of_spectrum(path, file)) {
        auto surface = made_surface(path, file, request.made, threads);
        auto processed = processing::apply(pipeline, std::move(surface.measurement), {}, threads);
        processed.records.insert(processed.records.begin(), surface.records.begin(), surface.records.end());
        return processed;
    }
    if (request.made.given())
        throw InvalidArgument(path +
                              ": `pixels`, `cell` and `surface` are of a surface made from a spectrum or a study; "
                              "expected them without a map");
    const auto options = file.read_options();
    const auto channel = formats::open_chosen(path, file.channel, options).front();
    auto read = processing::apply(pipeline, channel.read(), study::measurement_loader(options), threads);
    return into_contact(std::move(read), pipeline, channel.info.recommended_trend, request.measured, beyond, threads);
}

std::vector<PipelineResult> contact_surfaces(const std::string& path, const FileRequest& file,
                                             const processing::Pipeline& pipeline, const ContactSurfaceRequest& request,
                                             BeyondMap beyond, int count, parallel::Threads threads) {
    if (count > 1 && !is_of_spectrum(path, file))
        throw InvalidArgument(path +
                              ": several realisations are of a surface made from a spectrum or a study; "
                              "expected one of a map");
    std::vector<PipelineResult> surfaces;
    auto asked = request;
    for (int i = 0; i < count; ++i, ++asked.made.seed)
        surfaces.push_back(contact_surface(path, file, pipeline, asked, beyond, threads));
    return surfaces;
}

}  // namespace setae::answers
