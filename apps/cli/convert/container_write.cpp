// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "files/file_options.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/formats/container_draft.hpp"
#include "setae/formats/format.hpp"
#include "setae/study/provenance.hpp"
#include "setae/study/study.hpp"

namespace setae::cli::container_write_command {
namespace {

constexpr const char* explanation =
    "index.json  generation C of contact.engineering; meta.yml says the same for programs that know no other\n"
    "original    each file byte for byte; of files that only setae opens, text with names of columns or errors among them,\n"
    "            the heights as two columns or NetCDF, and the file itself as setae-source, which setae prefers\n"
    "copy        the same heights [index's unit] as classic NetCDF, scaled once, less the trend of detrend_mode; NaN and a mask: undefined\n"
    "older ones  are brought to generation C, with all they hold; a height scale that the original carries itself leaves the index\n"
    "bytes       stored, dated 1980: the same input gives the same container\n";

/// An option that holds for all files, or for one: "1 mm x 1 mm", "scan.npy=1 mm x 1 mm".
using FileValues = std::vector<std::string>;

struct Arguments {
    Common common;
    std::vector<std::string> files, from;
    std::string output, name, description, as;
    FileValues sizes, units, channels, trends;
};

/// The value for a file: that given for it, else that given for all.
std::string value_for(const std::string& file, const FileValues& values) {
    const auto base = std::filesystem::path(file).filename().string();
    std::string for_all;
    for (const auto& value : values) {
        for (const auto& name : {file, base})
            if (value.starts_with(name + "=")) return value.substr(name.size() + 1);
        if (value.find('=') == std::string::npos) for_all = value;
    }
    return for_all;
}

/// An option for a file that is not among those named is a slip.
void require_files(const Arguments& arguments, const FileValues& values, const char* option) {
    for (const auto& value : values) {
        const auto at = value.rfind('=');
        if (at == std::string::npos) continue;
        const bool named = std::any_of(arguments.files.begin(), arguments.files.end(), [&](const std::string& file) {
            return value_for(file, {value}) == value.substr(at + 1);
        });
        if (!named)
            throw InvalidArgument(
                fmt::format("{} '{}': no file '{}' is named; expected a value for all files, or FILE=value", option,
                            value, value.substr(0, at)));
    }
}

formats::StoredMeasurement stored(const std::string& file, const Arguments& arguments) {
    FileOptions options;
    options.size = value_for(file, arguments.sizes);
    options.unit = value_for(file, arguments.units);
    options.as = arguments.as;
    formats::StoredMeasurement measurement{.path = file, .options = options.read_options()};
    if (const auto channel = value_for(file, arguments.channels); !channel.empty()) {
        measurement.channel = channel.size() < 6 ? spelled<std::size_t>(channel) : std::nullopt;
        if (!measurement.channel)
            throw InvalidArgument(
                fmt::format("--channel '{}': expected a number counted from 0, as `setae info` lists them", channel));
    }
    if (const auto trend = value_for(file, arguments.trends); !trend.empty())
        measurement.trend = topography::trend_from_name(trend);
    return measurement;
}

formats::StoredMeasurement stored(const study::MeasurementInput& input, const std::filesystem::path& folder) {
    formats::StoredMeasurement measurement{
        .path = (folder / input.file).lexically_normal().string(), .channel = input.channel, .trend = input.trend};
    measurement.options.unit = input.unit;
    measurement.options.size = input.size;
    measurement.instrument.type = input.instrument;
    if (input.tip_radius) measurement.instrument.tip_radius = input.tip_radius->value;
    measurement.instrument.resolution = input.resolution;
    if (measurement.trend == topography::Trend::none) measurement.trend = topography::Trend::mean;
    return measurement;
}

bool is_container(const std::string& file) { return formats::detect_format(bytes::file_source(file)).is_container; }

std::string surface_name(const Arguments& arguments) {
    return arguments.name.empty() ? std::filesystem::path(arguments.output).stem().string() : arguments.name;
}

/// Surfaces of old containers may have no name, without which no program of today opens a container.
void name_surfaces(const std::string& name, formats::ContainerDraft& draft) {
    for (auto& surface : draft.container.surfaces) {
        if (!surface.name.empty()) continue;
        surface.name = name;
        draft.alerts.push_back(
            {"NAME_MISSING", name, "a surface without name was given this one", "give another by --name"});
    }
}

/// Adds what the command names, item by item: one that cannot be read is named and the others are added.
class Writer {
public:
    explicit Writer(const Arguments& arguments) : arguments_(arguments) {}

    /// Files that are no containers, as one surface; containers as their own surfaces.
    void add_files() {
        formats::ContainerSurface surface{.name = surface_name(arguments_),
                                          .category = "exp",
                                          .description = arguments_.description,
                                          .is_published = false};
        for (const auto& file : arguments_.files)
            add(file, [&] {
                if (is_container(file)) formats::add_container(draft_, bytes::file_source(file));
                else formats::add_measurement(draft_, surface, stored(file, arguments_));
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
    [[nodiscard]] bool any_failed() const { return failed_ > 0; }

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
        if (for_each_item({file}, [&](const std::string&) { body(); }) != ExitCode::done) ++failed_;
    }

    const Arguments& arguments_;
    formats::ContainerDraft draft_;
    std::size_t failed_ = 0;
};

ExitCode run(const Arguments& arguments) {
    if (arguments.output.empty()) throw InvalidArgument("no output; give it, as in -o measurements.zip");
    if (arguments.files.empty() && arguments.from.empty())
        throw InvalidArgument("no file; expected measured files or containers, or --from a container or study");
    require_files(arguments, arguments.sizes, "--size");
    require_files(arguments, arguments.units, "--unit");
    require_files(arguments, arguments.channels, "--channel");
    require_files(arguments, arguments.trends, "--detrend");
    Writer writer(arguments);
    for (const auto& file : arguments.from) writer.add_from(file);
    writer.add_files();
    auto& draft = writer.draft();
    if (draft.container.surfaces.empty())
        throw InvalidArgument(fmt::format("{}: nothing to put in, nothing was written", arguments.output));
    draft.container.versions["setae"] = study::version();
    name_surfaces(surface_name(arguments), draft);
    formats::write_container(arguments.output, draft.container, draft.members);

    auto violations = formats::schema_violations(draft.container);
    show(draft.alerts);
    show(violations);
    std::size_t measurements = 0;
    for (const auto& surface : draft.container.surfaces) measurements += surface.topographies.size();
    draft.alerts.insert(draft.alerts.end(), violations.begin(), violations.end());
    if (arguments.common.json)
        print_json({{"output", arguments.output},
                    {"surfaces", draft.container.surfaces.size()},
                    {"measurements", measurements},
                    {"members", draft.members.size()},
                    {"alerts", output::to_json(draft.alerts)}});
    else
        print(fmt::format("{}: surfaces {}, measurements {}\n", arguments.output, draft.container.surfaces.size(),
                          measurements));
    const bool unreadable = std::any_of(draft.alerts.begin(), draft.alerts.end(),
                                        [](const Alert& alert) { return alert.code == "UNREADABLE_MEMBER"; });
    return writer.any_failed() || unreadable ? ExitCode::some_failed : ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options
        .add("files", arguments->files, "measured files, which become one surface, and containers, which keep theirs")
        .of_inputs();
    options.add("-o,--output", arguments->output, "container to write, OUT.zip");
    options.add("--name", arguments->name, "name of the surface that the files are of; default: the output's");
    options.add("--description", arguments->description, "its description");
    options.add("--from", arguments->from, "containers and studies (.toml) whose surfaces are taken over");
    options.add("--size", arguments->sizes,
                "extent where files leave it open, \"1 mm x 1 mm\", or of one: \"FILE=1 mm x 1 mm\"");
    options.add("--unit", arguments->units, "unit of lengths where files leave it open, um, or of one: FILE=um");
    options.add("--channel", arguments->channels,
                "channel counted from 0, or of one file: FILE=1; default: the first of heights");
    options.add("--detrend", arguments->trends,
                "what is to be removed: mean, tilt or parabola, or of one file: FILE=tilt; default: mean");
    add_layout_option(options, arguments->as);
    options.example("setae container write afm.ibw stylus.csv -o surface.zip --name \"my surface\"",
                    "two measurements of one surface");
    options.example("setae container write --from study.toml -o surfaces.zip", "the surfaces of a study");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::container_write_command
