// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "setae/answers/containers.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"
#include "setae/study/measurement_options.hpp"
#include "setae/study/provenance.hpp"
#include "setae/study/study.hpp"

namespace setae::answers {
namespace {

/// The value for a file: the one given for it, else the one given for all.
std::string value_for(const std::string& file, const std::vector<std::string>& values) {
    const auto base = std::filesystem::path(file).filename().string();
    std::string for_all;
    for (const auto& value : values) {
        for (const auto& name : {file, base})
            if (value.starts_with(name + "=")) return value.substr(name.size() + 1);
        if (value.find('=') == std::string::npos) for_all = value;
    }
    return for_all;
}

/// An option for a file that is not named is an error.
void require_files(const ContainerRequest& request, const std::vector<std::string>& values, const char* option) {
    for (const auto& value : values) {
        const auto at = value.rfind('=');
        if (at == std::string::npos) continue;
        const bool named = std::any_of(request.files.begin(), request.files.end(), [&](const std::string& file) {
            return value_for(file, {value}) == value.substr(at + 1);
        });
        if (!named)
            throw InvalidArgument(
                fmt::format("{} '{}': no file '{}' is named; expected a value for all files, or FILE=value", option,
                            value, value.substr(0, at)));
    }
}

formats::StoredMeasurement stored(const std::string& file, const ContainerRequest& request) {
    FileRequest options;
    options.size = value_for(file, request.sizes);
    options.unit = value_for(file, request.units);
    options.as = request.as;
    options.keep_values = request.keep_values;
    formats::StoredMeasurement measurement{.path = file, .options = options.read_options()};
    if (const auto channel = value_for(file, request.channels); !channel.empty()) measurement.channel = channel;
    if (const auto trend = value_for(file, request.trends); !trend.empty())
        measurement.trend = topography::trend_from_name(trend);
    return measurement;
}

/// "1 ± 0.02"; empty for a factor that is not stated.
std::string factor_text(const std::optional<Estimate>& factor) {
    if (!factor) return {};
    return factor->uncertain() ? fmt::format("{} ± {}", factor->value, factor->standard_error)
                               : fmt::format("{}", factor->value);
}

formats::StoredMeasurement stored(const study::MeasurementInput& input, const std::filesystem::path& folder) {
    formats::StoredMeasurement measurement{
        .path = (folder / input.file).lexically_normal().string(), .channel = input.channel, .trend = input.trend};
    measurement.options = study::read_options(input);
    measurement.instrument.type = input.instrument;
    if (input.tip_radius) {
        measurement.instrument.tip_radius = input.tip_radius->value;
        if (input.tip_radius->uncertain())
            measurement.instrument.tip_radius_standard_error = input.tip_radius->standard_error;
    }
    measurement.height_calibration = factor_text(input.height_calibration);
    measurement.lateral_calibration = factor_text(input.lateral_calibration);
    measurement.instrument.resolution = input.resolution;
    if (measurement.trend == topography::Trend::none) measurement.trend = topography::Trend::mean;
    return measurement;
}

bool is_container(const std::string& file) { return formats::detect_format(bytes::file_source(file)).is_container; }

std::string surface_name(const ContainerRequest& request) {
    return request.name.empty() ? std::filesystem::path(request.output).stem().string() : request.name;
}

/// Surfaces of old containers may have no name, without which no program of today opens a container.
void name_surfaces(const std::string& name, formats::ContainerDraft& draft) {
    for (auto& surface : draft.container.surfaces) {
        if (!surface.name.empty()) continue;
        surface.name = name;
        draft.alerts.push_back(
            {"NAME_MISSING", name, "a surface without name was given this one", "give another by `name`"});
    }
}

/// Adds the named contents, item by item: one that cannot be read is reported and the others are added.
class ContainerWriter {
public:
    explicit ContainerWriter(const ContainerRequest& request) : request_(request) {}

    /// Files that are no containers, as one surface; containers as their own surfaces.
    void add_files() {
        formats::ContainerSurface surface{.name = surface_name(request_),
                                          .category = "exp",
                                          .description = request_.description,
                                          .is_published = false};
        for (const auto& file : request_.files)
            add(file, [&] {
                if (is_container(file)) formats::add_container(draft_, bytes::file_source(file));
                else formats::add_measurement(draft_, surface, stored(file, request_));
            });
        if (!surface.topographies.empty()) draft_.container.surfaces.push_back(std::move(surface));
    }

    void add_from(const std::string& file) {
        if (!file.ends_with(".toml")) {
            add(file, [&] { formats::add_container(draft_, bytes::file_source(file)); });
            return;
        }
        study::Study study;
        add(file, [&] { study = study::read_study(file); });
        for (const auto& input : study.surfaces) add_surface(input, std::filesystem::path(file).parent_path());
    }

    [[nodiscard]] formats::ContainerDraft& draft() { return draft_; }
    [[nodiscard]] const std::vector<std::string>& failures() const { return failures_; }

private:
    void add_surface(const study::SurfaceInput& input, const std::filesystem::path& folder) {
        formats::ContainerSurface surface{
            .name = input.name, .category = "exp", .description = input.description, .is_published = false};
        for (const auto& measurement : input.measurements) {
            const auto wanted = stored(measurement, folder);
            add(wanted.path, [&] {
                if (is_container(wanted.path)) formats::add_measurements_of(draft_, surface, wanted);
                else formats::add_measurement(draft_, surface, wanted);
            });
        }
        if (!surface.topographies.empty()) draft_.container.surfaces.push_back(std::move(surface));
    }

    void add(const std::string& file, const std::function<void()>& body) {
        try {
            body();
        } catch (const Error& error) {
            if (request_.every_file) throw;
            failures_.emplace_back(error.what());
        } catch (const std::exception& error) {
            if (request_.every_file) throw;
            failures_.push_back(reason_of(error, file));
        }
    }

    const ContainerRequest& request_;
    formats::ContainerDraft draft_;
    std::vector<std::string> failures_;
};

}  // namespace

std::size_t WrittenContainer::measurements() const {
    std::size_t count = 0;
    for (const auto& surface : draft.container.surfaces) count += surface.topographies.size();
    return count;
}

bool WrittenContainer::complete() const {
    return failures.empty() && std::none_of(draft.alerts.begin(), draft.alerts.end(),
                                            [](const Alert& alert) { return alert.code == "UNREADABLE_MEMBER"; });
}

WrittenContainer write_container(const ContainerRequest& request) {
    if (request.output.empty()) throw InvalidArgument("no output; expected `output = measurements.zip`");
    if (request.files.empty() && request.from.empty())
        throw InvalidArgument("no file; expected measured files or containers, or `from` with a container or study");
    require_files(request, request.sizes, "`size`");
    require_files(request, request.units, "`unit`");
    require_files(request, request.channels, "`channel`");
    require_files(request, request.trends, "`detrend`");
    ContainerWriter writer(request);
    for (const auto& file : request.from) writer.add_from(file);
    writer.add_files();
    WrittenContainer written{
        .output = request.output, .draft = std::move(writer.draft()), .failures = writer.failures()};
    auto& draft = written.draft;
    if (draft.container.surfaces.empty()) return written;
    draft.container.versions["setae"] = study::version();
    name_surfaces(surface_name(request), draft);
    formats::write_container(request.output, draft.container, draft.members);
    const auto violations = formats::schema_violations(draft.container);
    draft.alerts.insert(draft.alerts.end(), violations.begin(), violations.end());
    return written;
}

void require_written(const WrittenContainer& written) {
    if (written.draft.container.surfaces.empty())
        throw InvalidArgument(fmt::format("{}: nothing to put in, nothing was written", written.output));
}

}  // namespace setae::answers
