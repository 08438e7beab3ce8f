// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/open_loop.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/imaging/contact_radius.hpp"
#include "setae/study/channel_remedy.hpp"
#include "setae/tables/clocks.hpp"
#include "setae/tables/loop_file.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study {
namespace {

/// Messages about reversed or swapped channels end with the remedy.
template <class Computation>
auto with_remedies(const tables::ChannelNames& channels, Computation&& computation) {
    try {
        return computation();
    } catch (const loops::ChannelFaultError& error) {
        throw loops::ChannelFaultError(error.fault(),
                                       fmt::format("{}; {}", error.what(), channel_remedy(error.fault(), channels)));
    }
}

/// Messages of a computation begin with the file it is about.
template <class Computation>
auto naming(const std::string& file, Computation&& computation) {
    const auto named = [&](const std::string& message) {
        return message.starts_with(file) ? message : file + ": " + message;
    };
    try {
        return computation();
    } catch (const loops::ChannelFaultError& error) {
        throw loops::ChannelFaultError(error.fault(), named(error.what()));
    } catch (const UndefinedDataError& error) {
        throw UndefinedDataError(named(error.what()));
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(named(error.what()));
    }
}

OpenedLoop in_chosen_columns(OpenedLoop opened, const LoopSource& source) {
    opened.channels = tables::choose_columns(opened.table, source.file, source.columns);
    return opened;
}

/// Names of a mapping's own columns replace those of the file.
tables::ChannelNames channels_of(const tables::Mapping& mapping) {
    tables::ChannelNames channels;
    for (const auto& result : mapping.results) channels[result.name] = {"", "", result.expression};
    return channels;
}

OpenedLoop read_unmapped(const LoopSource& source) {
    const auto file = bytes::file_source(source.file);
    if (tables::is_loop_file(file)) return in_chosen_columns({.table = tables::read_loop(source.file)}, source);
    if (tables::force_curve_format(file)) {
        auto curve = tables::read_force_curve(file, source.force_curve);
        require_constants(curve, source.file);
        return in_chosen_columns({.table = std::move(curve)}, source);
    }
    auto loop = tables::read_loop_table(
        source.file, source.camera ? tables::LoopColumns::force_record : tables::LoopColumns::complete, source.columns);
    OpenedLoop opened{.table = std::move(loop.table), .channels = std::move(loop.channels)};
    if (const auto others = opened.table.metadata.find("other_sheets"); others != opened.table.metadata.end())
        opened.alerts.push_back(
            {"SHEET_CHOSEN", source.file,
             fmt::format("the sheet '{}' was read; other sheets with a table: {}", opened.table.metadata.at("sheet"),
                         others->second),
             "to read another sheet, use `setae jkr import --sheet NAME` or a mapping file that names it"});
    for (const auto& sentence : loop.taken)
        opened.alerts.push_back(
            {"COLUMN_GUESSED", source.file, sentence, "to use another column, set columns = { ROLE = \"COLUMN\" }"});
    if (!loop.unused.empty())
        opened.alerts.push_back({"COLUMN_UNUSED", source.file,
                                 fmt::format("not used: {}", fmt::join(loop.unused, ", ")),
                                 "if one of them is force, displacement, contact_radius or time, name it so"});
    return opened;
}

/// Whether a path is pictures, not a table of radii.
bool is_recording(const std::string& path) {
    if (std::filesystem::is_directory(path)) return true;
    const auto head = bytes::file_source(path).head(12);
    return head.starts_with(std::string_view("II*\0", 4)) || head.starts_with(std::string_view("MM\0*", 4)) ||
           head.starts_with("II+") || (head.starts_with("RIFF") && head.ends_with("AVI "));
}

Table radii_of(const CameraInput& camera, std::vector<Alert>& alerts) {
    if (camera.mapping) return tables::read_mapped_table(camera.file, tables::read_mapping(*camera.mapping));
    if (!is_recording(camera.file)) return tables::read_table(camera.file);
    const imaging::FrameSource frames(camera.file, {.pixel_size = camera.pixel_size, .frame_rate = camera.frame_rate});
    const auto radii = imaging::measure_contact_radii(frames, {.frame = {.fringes = camera.fringes}});
    const auto& found = radii.summary;
    if (const auto lost = found.not_found + found.bad; lost > 0)
        alerts.push_back({"FRAMES_BAD", camera.file,
                          fmt::format("{} of {} frames have no contact radius", lost, found.frames),
                          "look at these frames in the overlay of `setae jkr radius`"});
    return imaging::as_table(radii);
}

void align(OpenedLoop& opened, const LoopSource& source) {
    const auto camera = radii_of(*source.camera, opened.alerts);
    tables::require_one_clock(camera, source.camera->file);
    double offset = source.camera->clock_offset.value_or(0.0);
    if (!source.camera->clock_offset) {
        const auto* displacement = opened.table.find("displacement");
        opened.clock = naming(source.camera->file, [&] {
            return loops::align_clocks({.time = opened.table.at("time"),
                                        .force = opened.table.at("force"),
                                        .displacement = displacement ? displacement->values : Array1D()},
                                       {.time = camera.at("time"), .contact_radius = camera.at("contact_radius")});
        });
        offset = opened.clock->offset.value;
        if (!opened.clock->doubt.empty())
            opened.alerts.push_back(
                {"CLOCK_DOUBTFUL", source.file,
                 fmt::format("the clock of the camera was set {:.4g} s after that of the force, but {}", offset,
                             opened.clock->doubt),
                 "compare jump-in and pull-off in both records and give the offset"});
    }
    opened.table = naming(source.camera->file, [&] { return tables::merged_by_time(opened.table, camera, offset); });
    if (opened.clock)
        opened.table.metadata["camera_clock_offset_error"] = fmt::format("{} s", opened.clock->offset.standard_error);
    const auto& outside = opened.table.metadata.at("frames_outside");
    if (outside != "0")
        opened.alerts.push_back(
            {"FRAMES_OUTSIDE", source.file,
             fmt::format("{} frames of {} lie outside the force record", outside, source.camera->file),
             "check the clock offset"});
}

OpenedLoop on_one_clock(const LoopSource& source, OpenedLoop opened) {
    if (!source.camera) return opened;
    tables::require_one_clock(opened.table, source.file);
    align(opened, source);
    return opened;
}

}  // namespace

std::vector<std::string> LoopSource::files() const {
    std::vector<std::string> names{file};
    if (mapping) names.push_back(*mapping);
    if (!camera) return names;
    if (std::filesystem::is_directory(camera->file)) {
        const auto pictures = names.size();
        for (const auto& entry : std::filesystem::directory_iterator(camera->file))
            if (entry.is_regular_file()) names.push_back(entry.path().string());
        std::sort(names.begin() + static_cast<std::ptrdiff_t>(pictures), names.end());
    } else {
        names.push_back(camera->file);
    }
    if (camera->mapping) names.push_back(*camera->mapping);
    return names;
}

void require_constants(const Table& curve, const std::string& file) {
    if (const auto missing = curve.metadata.find("missing"); missing != curve.metadata.end())
        throw FormatError(
            file, {},
            fmt::format("the file does not state the {}; give `spring_constant` and `sensitivity`", missing->second));
}

OpenedLoop open_loop(const LoopSource& source) {
    return source.mapping
               ? open_loop(source, tables::with_results(tables::read_mapping(*source.mapping), source.columns))
               : on_one_clock(source, read_unmapped(source));
}

OpenedLoop open_loop(const LoopSource& source, const tables::Mapping& mapping) {
    return on_one_clock(source,
                        {.table = tables::read_mapped_table(source.file, mapping), .channels = channels_of(mapping)});
}

namespace {

/// A warning where W is above 0 by its error, and too small for any two solids in air.
void add_small_work(loops::LoopAnalysis& analysis, const loops::LensAndCounterBody& bodies, const std::string& file) {
    const auto& fit = analysis.loading.primary();
    const auto& work = fit.work_of_adhesion;
    constexpr double usual = 0.05, errors = 3.0;
    const bool small = fit.converged && work.value < min_work_of_adhesion && work.value > errors * work.standard_error;
    if (!small || !(work.value > 0.0) || std::any_of(analysis.alerts.begin(), analysis.alerts.end(), names_cause))
        return;
    const double power = 3.0 * std::round(std::log10(usual / work.value) / 3.0);
    analysis.alerts.push_back(
        {"UNITS_IMPLAUSIBLE", file,
         fmt::format("W = {} is below {}: forces of {} are too small for a sphere radius of {}, and the likely "
                     "factor is 10^{:.0f}",
                     format_value(work.value, "J/m2", 3), format_value(min_work_of_adhesion, "J/m2", 3),
                     format_value(1.5 * pi * bodies.radius * work.value, "N", 3), format_value(bodies.radius, "m", 3),
                     power),
         "check the units of force and sphere radius"});
}

}  // namespace

bool names_cause(const Alert& alert) { return alert.code == "UNITS_IMPLAUSIBLE"; }

StatedBodies bodies_stated_in(const Table& loop) {
    using loops::SharedInput;
    const auto stated = [&](const char* key) { return tables::loop_quantity(loop, key); };
    const auto exact = [&](const char* key, double otherwise) {
        const auto value = stated(key);
        return value ? value->value : otherwise;
    };
    StatedBodies bodies;
    auto& values = bodies.values;
    bodies.take(SharedInput::sphere_radius, values.radius, stated("sphere_radius"));
    bodies.take(SharedInput::poisson_ratio, values.lens_poisson_ratio, stated("lens_poisson_ratio"));
    bodies.take(SharedInput::sphere_height, values.lens_height, stated("lens_height"));
    bodies.take(SharedInput::sphere_height, values.layer_thickness, stated("layer_thickness"));
    values.counter_youngs_modulus = exact("counter_youngs_modulus", std::numeric_limits<double>::infinity());
    values.counter_poisson_ratio = exact("counter_poisson_ratio", values.counter_poisson_ratio);
    return bodies;
}

void apply(const loops::Calibration& factors, OpenedLoop& loop) {
    for (auto& column : loop.table.columns) {
        if (column.name == "force") column.values *= factors.force;
        if (column.name == "displacement") column.values *= factors.displacement;
        if (column.name == "contact_radius") column.values *= factors.contact_radius;
    }
}

loops::LoopAnalysis analyse_loop(const OpenedLoop& opened, const std::string& file,
                                 const loops::LensAndCounterBody& bodies, const loops::AnalysisOptions& options) {
    return naming(file, [&] {
        auto analysis = with_remedies(opened.channels, [&] {
            return loops::analyse(loops::loop_from_table(opened.table), bodies, options, file);
        });
        analysis.alerts.insert(analysis.alerts.begin(), opened.alerts.begin(), opened.alerts.end());
        add_small_work(analysis, bodies, file);
        std::stable_partition(analysis.alerts.begin(), analysis.alerts.end(), names_cause);
        return analysis;
    });
}

loops::LoopAnalysis analyse_loop(const OpenedLoop& opened, const std::string& file, const StatedBodies& bodies,
                                 const loops::AnalysisOptions& options) {
    auto analysis = analyse_loop(opened, file, bodies.values, options);
    const auto recorded = loops::loop_from_table(opened.table);
    for (const auto& [input, standard_error] : bodies.standard_errors)
        loops::add_input_error(analysis, bodies.values, {recorded, bodies.values, options, analysis, input},
                               standard_error);
    return analysis;
}

loops::LoopAnalysis analyse_loop(const LoopSource& source, const loops::LensAndCounterBody& bodies,
                                 const loops::AnalysisOptions& options) {
    return analyse_loop(open_loop(source), source.file, bodies, options);
}

}  // namespace setae::study
