// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/formats/container_draft.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "container_measurement.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/bytes/expand.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/named_choice.hpp"
#include "setae/core/units.hpp"
#include "setae/formats/format.hpp"
#include "setae/formats/netcdf.hpp"
#include "setae/tables/dialect.hpp"

namespace setae::formats {
namespace {

using topography::HeightMap, topography::Measurement;

// ---- names of members -----------------------------------------------------------------------------------------------

bool is_taken(const ContainerDraft& draft, const std::string& name) {
    if (name == "index.json" || name == "meta.yml") return true;
    return std::any_of(draft.members.begin(), draft.members.end(),
                       [&](const ContainerMember& member) { return member.name == name; });
}

/// The name, or the name after the first number that makes it unique.
std::string free_name(const ContainerDraft& draft, const std::string& name) {
    auto free = name;
    for (int number = 1; is_taken(draft, free); ++number) free = fmt::format("{}-{}", number, name);
    return free;
}

/// The name of a file in portable characters, after the number of its measurement.
std::string member_name(std::size_t number, const std::string& path) {
    auto name = std::filesystem::path(path).filename().string();
    for (auto& character : name)
        if (!std::isalnum(static_cast<unsigned char>(character)) && character != '.' && character != '-' &&
            character != '_')
            character = '-';
    return fmt::format("{}-{}", number, name);
}

std::string copy_name(const std::string& original) {
    return std::filesystem::path(original).replace_extension().string() + "-squeezed.nc";
}

std::string plain_name(const std::string& source, bool is_map) {
    return std::filesystem::path(source).replace_extension().string() + (is_map ? "-heights.nc" : "-heights.txt");
}

// ---- entries of the index for a file --------------------------------------------------------------------------------

/// The unit of lengths in an index; contact.engineering supports m, mm, µm, nm, Å and pm.
std::string index_unit(const std::string& unit, bool numbers_depend_on_it, const std::string& path) {
    for (const char* known : {"m", "mm", "µm", "nm", "Å", "pm"})
        if (unit == known) return unit;
    if (numbers_depend_on_it)
        throw InvalidArgument(
            fmt::format("{}: containers do not allow the unit '{}'; expected m, mm, um, nm, Å or pm", path, unit));
    return unit == "cm" ? "mm" : "µm";
}

std::string detrend_mode(topography::Trend trend) {
    switch (trend) {
        case topography::Trend::mean: return "center";
        case topography::Trend::tilt: return "height";
        case topography::Trend::parabola: return "curvature";
        case topography::Trend::none: break;
    }
    throw InvalidArgument("containers cannot state that no trend was removed; expected mean, tilt or parabola");
}

constexpr std::array<const char*, 12> months{"jan", "feb", "mar", "apr", "may", "jun",
                                             "jul", "aug", "sep", "oct", "nov", "dec"};

std::string iso_date(int year, int month, int day) {
    const bool possible = year >= 1900 && year < 2100 && month >= 1 && month <= 12 && day >= 1 && day <= 31;
    return possible ? fmt::format("{:04}-{:02}-{:02}", year, month, day) : std::string{};
}

/// 2016-02-15 from unambiguous forms: 2016-02-15…, 2016/02/15, 15.02.2016, Feb 15 2016, 15 Feb 2016; otherwise empty.
std::string date_of(const std::string& time) {
    std::array<int, 3> numbers{};
    char first = 0, second = 0;
    const auto fields = [&](const char* pattern) {
        return std::sscanf(time.c_str(), pattern, &numbers[0], &first, &numbers[1], &second, &numbers[2]) == 5 &&
               first == second;
    };
    if (fields("%4d%c%2d%c%2d") && (first == '-' || first == '/') && numbers[0] > 31)
        return iso_date(numbers[0], numbers[1], numbers[2]);
    if (fields("%2d%c%2d%c%4d") && first == '.') return iso_date(numbers[2], numbers[1], numbers[0]);
    std::vector<std::string_view> words;
    const auto lower = bytes::lowered(time);
    tables::split_cells(lower, ' ', words);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto month =
            std::find_if(months.begin(), months.end(), [&](const char* name) { return words[i].starts_with(name); });
        if (month == months.end()) continue;
        int day = 0, year = 0;
        for (std::size_t k = i == 0 ? 0 : i - 1; k < std::min(i + 4, words.size()); ++k) {
            const int number = std::atoi(std::string(words[k]).c_str());
            if (number >= 1900) year = number;
            else if (day == 0 && words[k].find(':') == std::string_view::npos) day = number;
        }
        return iso_date(year, static_cast<int>(month - months.begin()) + 1, day);
    }
    return {};
}

/// contact.engineering distinguishes contact-based and microscope-based instruments.
std::string instrument_type(const topography::Instrument& instrument) {
    if (instrument.type == "stylus" || instrument.type == "afm") return "contact-based";
    if (!instrument.type.empty()) return "microscope-based";
    return instrument.tip_radius ? "contact-based" : instrument.resolution ? "microscope-based" : "undefined";
}

/// A number as originally written: 500, not 500.00000000000006 after conversion to metres.
double without_rounding(double number) { return std::stod(fmt::format("{:.15g}", number)); }

ContainerLength in_nanometres(double length) { return {.value = without_rounding(length / units::nm), .unit = "nm"}; }

/// Instrument data of a file, completed by the given data.
topography::Instrument with_given(topography::Instrument instrument, const topography::Instrument& given) {
    if (!given.name.empty()) instrument.name = given.name;
    if (!given.type.empty()) instrument.type = given.type;
    if (given.tip_radius) {
        instrument.tip_radius = given.tip_radius;
        instrument.tip_radius_standard_error = given.tip_radius_standard_error;
    }
    if (given.resolution) instrument.resolution = given.resolution;
    return instrument;
}

std::optional<ContainerInstrument> container_instrument(const topography::Instrument& of_file,
                                                        const StoredMeasurement& given) {
    const auto instrument = with_given(of_file, given.instrument);
    ContainerInstrument::Parameters parameters{.height_calibration = given.height_calibration,
                                               .lateral_calibration = given.lateral_calibration};
    if (instrument.tip_radius) parameters.tip_radius = in_nanometres(*instrument.tip_radius);
    if (instrument.tip_radius && instrument.tip_radius_standard_error)
        parameters.tip_radius_standard_error = in_nanometres(*instrument.tip_radius_standard_error);
    if (instrument.resolution) parameters.resolution = in_nanometres(*instrument.resolution);
    ContainerInstrument result{.name = instrument.name, .type = instrument_type(instrument)};
    const bool has_parameters = parameters != ContainerInstrument::Parameters{};
    if (result.name.empty() && result.type == "undefined" && !has_parameters) return std::nullopt;
    if (has_parameters) result.parameters = std::move(parameters);
    return result;
}

bool is_periodic(const Measurement& measurement) {
    return std::visit(
        [](const auto& m) {
            if constexpr (requires { m.periodic; }) return m.periodic;
            return false;
        },
        measurement);
}

/// Adds properties of the heights that the index lacks.
void describe_heights(const Measurement& measurement, ContainerTopography& topography) {
    const auto heights = topography::all_heights(measurement);
    const auto undefined_points = heights.isNaN().count();
    if (!topography.has_undefined_data) topography.has_undefined_data = undefined_points > 0;
    if (!topography.undefined_data_fraction)
        topography.undefined_data_fraction =
            static_cast<double>(undefined_points) / static_cast<double>(heights.size());
    if (!topography.is_periodic) topography.is_periodic = is_periodic(measurement);
}

void set_size(const ChannelInfo& info, ContainerTopography& topography) {
    const double factor = unit_factor(topography.unit, dimension::length);
    topography.size.clear();
    for (const double size : info.size) topography.size.push_back(without_rounding(size / factor));
}

// ---- originals for other programs -----------------------------------------------------------------------------------

bool others_read(const Format& format, const Measurement& measurement) {
    const bool reads_maps_alone = format.identifier == "x3p";
    return format.read_elsewhere && (!reads_maps_alone || std::holds_alternative<HeightMap>(measurement));
}

/// The unit of an original for other programs. They treat steps as equal that differ by less than a relative 10⁻⁶.
std::string unit_of_positions(const std::string& unit, const Measurement& measurement) {
    const auto* profile = std::get_if<topography::Profile>(&measurement);
    if (profile == nullptr) return unit;
    return profile->size() < 1.0 * units::mm ? "nm" : "µm";
}

std::string columns_text(const Array1D& x, const Array1D& heights, double unit) {
    fmt::memory_buffer text;
    for (Index i = 0; i < x.size(); ++i)
        fmt::format_to(std::back_inserter(text), "{:.15g}\t{:.15g}\n", x[i] / unit, heights[i] / unit);
    return fmt::to_string(text);
}

/// A map as classic NetCDF; a curve as two columns of numbers, x and height.
std::string plain_content(const Measurement& measurement, const std::string& unit) {
    const double factor = unit_factor(unit, dimension::length);
    if (const auto* scan = std::get_if<topography::LineScan>(&measurement)) {
        const auto n = scan->heights.size();
        return columns_text(scan->pixel_size() * Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)), scan->heights,
                            factor);
    }
    if (const auto* profile = std::get_if<topography::Profile>(&measurement))
        return columns_text(profile->positions, profile->heights, factor);
    return netcdf_content(measurement, unit);
}

/// Adds the file of the instrument next to an original with the same content in a layout for other programs.
void put_source(const std::function<Measurement()>& read, bool is_map, ContainerDraft& draft,
                ContainerTopography& topography) {
    auto& [original, source, source_channel, squeezed, rest] = topography.datafile;
    source = std::exchange(original, free_name(draft, plain_name(original, is_map)));
    source_channel = std::exchange(topography.data_source, 0);
    draft.members.push_back({original, [name = original, read, unit = topography.unit] {
                                 return bytes::memory_source(name, plain_content(read(), unit));
                             }});
}

/// The processed copy, computed when it is written.
ContainerMember copy_of(const std::string& name, std::function<Measurement()> read, topography::Trend trend,
                        const std::string& unit) {
    return {name, [name, read = std::move(read), trend, unit] {
                return bytes::memory_source(name, netcdf_content(topography::detrended(read(), trend), unit));
            }};
}

// ---- upgrading ------------------------------------------------------------------------------------------------------

/// New names of the members of the old container.
using NewNames = std::map<std::string, std::string>;

NewNames take_members(ContainerDraft& draft, const bytes::Source& source, const std::vector<std::string>& members) {
    NewNames names;
    const bytes::Archive archive(source);
    for (const auto& name : members) {
        const auto free = free_name(draft, name);
        names[name] = free;
        draft.members.push_back({free, [archive, name] { return archive.member(name); }});
    }
    return names;
}

void rename(const NewNames& names, std::string& member) {
    if (const auto found = names.find(member); found != names.end()) member = found->second;
}

void take_scale_out(const bytes::Archive& archive, const bytes::Source& source, ContainerDraft& draft,
                    ContainerTopography& topography) {
    if (!repeats_scale(archive, topography)) return;
    draft.alerts.push_back(
        {"SCALE_TWICE", fmt::format("{}: {}", source.name, topography.name),
         fmt::format("the index repeats the height scale {}, which {} already contains; it was removed from the "
                     "index",
                     *topography.height_scale, topography.datafile.original),
         "compute again results of programs that applied both scales: their heights were wrong by this "
         "factor"});
    topography.height_scale.reset();
}

void add_copy(const Channel& channel, ContainerDraft& draft, ContainerTopography& topography) {
    const bool filled =
        !topography.fill_undefined_data_mode.empty() && topography.fill_undefined_data_mode != "do-not-fill";
    if (!topography.datafile.squeezed.empty() || topography.unit.empty()) return;
    if (filled) {
        draft.alerts.push_back(
            {"NO_PROCESSED_COPY", topography.name,
             fmt::format("the processed copy must be filled by '{}', which setae does not do; it was not written",
                         topography.fill_undefined_data_mode),
             "use a program that makes the copy from the original"});
        return;
    }
    const auto name = free_name(draft, copy_name(topography.datafile.original));
    draft.members.push_back(copy_of(
        name, channel.read, trend_of(topography.detrend_mode).value_or(topography::Trend::mean), topography.unit));
    topography.datafile.squeezed = name;
}

/// Completes a measurement of the index from its file.
void upgrade(const bytes::Source& source, const bytes::Archive& archive, const ContainerSurface& surface,
             ContainerDraft& draft, ContainerTopography& topography) {
    const auto channel = container_channel(source, archive, surface, topography);
    draft.alerts.insert(draft.alerts.end(), channel.info.alerts.begin(), channel.info.alerts.end());
    if (topography.name.empty())
        topography.name =
            topography.datafile.original.empty() ? topography.datafile.squeezed : topography.datafile.original;
    if (!channel.info.is_height) return;
    take_scale_out(archive, source, draft, topography);
    if (topography.unit.empty() && !channel.info.unit.empty())
        topography.unit = index_unit(channel.info.unit, false, topography.name);
    if (topography.size.empty() && !topography.unit.empty()) set_size(channel.info, topography);
    try {
        describe_heights(channel.read(), topography);
        add_copy(channel, draft, topography);
    } catch (const Error& error) {
        draft.alerts.push_back({"UNREADABLE_MEMBER", topography.name, error.what(),
                                "the member is kept unchanged; repair or replace this measurement"});
    }
}

/// Converts measurements of a container to generation C and adds their members.
void upgrade_all(ContainerDraft& draft, const bytes::Source& source, const std::vector<std::string>& members,
                 std::vector<ContainerSurface>& surfaces) {
    const bytes::Archive archive(source);
    const auto names = take_members(draft, source, members);
    for (auto& surface : surfaces)
        for (auto& topography : surface.topographies) {
            upgrade(source, archive, surface, draft, topography);
            rename(names, topography.datafile.original);
            rename(names, topography.datafile.source);
            rename(names, topography.datafile.squeezed);
        }
}

/// Keeps only the measurement with a number, counted over all surfaces, or a name.
void keep_only(const std::string& wanted, const std::string& path, std::vector<ContainerSurface>& surfaces) {
    std::vector<std::string> names;
    for (const auto& surface : surfaces)
        for (const auto& topography : surface.topographies) names.push_back(topography.name);
    std::size_t place = 0;
    try {
        place = chosen_by_name(wanted, names, "measurement");
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(fmt::format("{}: {}", path, error.what()));
    }
    std::size_t count = 0;
    for (auto& surface : surfaces) {
        std::vector<ContainerTopography> kept;
        for (auto& topography : surface.topographies)
            if (count++ == place) kept.push_back(std::move(topography));
        surface.topographies = std::move(kept);
    }
}

std::vector<std::string> members_of(const std::vector<ContainerSurface>& surfaces,
                                    const std::vector<std::string>& members) {
    std::vector<std::string> named;
    for (const auto& name : members)
        for (const auto& surface : surfaces)
            for (const auto& topography : surface.topographies)
                for (const auto& member :
                     {topography.datafile.original, topography.datafile.source, topography.datafile.squeezed})
                    if (name == member) named.push_back(name);
    std::sort(named.begin(), named.end());
    named.erase(std::unique(named.begin(), named.end()), named.end());
    return named;
}

void replace_given(const StoredMeasurement& given, ContainerTopography& topography) {
    if (given.trend && detrend_mode(*given.trend) != topography.detrend_mode) {
        topography.detrend_mode = detrend_mode(*given.trend);
        topography.datafile.squeezed = topography.datafile.original.empty()
                                           ? topography.datafile.squeezed
                                           : "";  // a copy with another trend is computed
    }
    topography::Instrument known;
    if (topography.instrument) known.name = topography.instrument->name;
    const bool any = !given.instrument.name.empty() || !given.instrument.type.empty() || given.instrument.tip_radius ||
                     given.instrument.resolution || !given.height_calibration.empty() ||
                     !given.lateral_calibration.empty();
    if (any) topography.instrument = container_instrument(known, given);
}

}  // namespace

void add_measurement(ContainerDraft& draft, ContainerSurface& surface, const StoredMeasurement& measurement) {
    const auto channels = open(measurement.path, measurement.options);
    const auto index = chosen_channels(measurement.path, channels, measurement.channel).front();
    const auto& channel = channels[index];
    const auto heights = channel.read();
    const auto trend = measurement.trend.value_or(topography::Trend::mean);

    ContainerTopography topography;
    topography.name = std::filesystem::path(measurement.path).filename().string();
    topography.datafile.original = free_name(draft, member_name(surface.topographies.size(), measurement.path));
    topography.data_source = index;
    const bool unit_is_given = measurement.options.unit.has_value();
    topography.unit = index_unit(channel.info.unit, unit_is_given, measurement.path);
    const bool is_plain = others_read(detect_format(bytes::unpacked(bytes::file_source(measurement.path))), heights);
    if (!is_plain && !unit_is_given) topography.unit = unit_of_positions(topography.unit, heights);
    set_size(channel.info, topography);
    topography.fill_undefined_data_mode = "do-not-fill";
    topography.detrend_mode = detrend_mode(trend);
    describe_heights(heights, topography);
    topography.measurement_date = date_of(channel.info.metadata.acquisition_time);
    topography.instrument = container_instrument(topography::metadata(heights).instrument, measurement);

    draft.alerts.insert(draft.alerts.end(), channel.info.alerts.begin(), channel.info.alerts.end());
    draft.members.push_back(
        {topography.datafile.original, [path = measurement.path] { return bytes::file_source(path); }});
    topography.datafile.squeezed = free_name(draft, copy_name(topography.datafile.original));
    const auto read_again = [path = measurement.path, index, options = measurement.options] {
        return read(path, index, options);
    };
    if (!is_plain) put_source(read_again, std::holds_alternative<HeightMap>(heights), draft, topography);
    draft.members.push_back(copy_of(topography.datafile.squeezed, read_again, trend, topography.unit));
    surface.topographies.push_back(std::move(topography));
}

void add_container(ContainerDraft& draft, const bytes::Source& source) {
    auto file = read_container(source);
    upgrade_all(draft, source, file.members, file.container.surfaces);
    auto& container = draft.container;
    std::move(file.container.surfaces.begin(), file.container.surfaces.end(), std::back_inserter(container.surfaces));
    if (container.created_at.empty()) container.created_at = file.container.created_at;
    if (container.extra.empty()) container.extra = file.container.extra;
    for (const auto& [program, version] : file.container.versions) container.versions.emplace(program, version);
    draft.alerts.insert(draft.alerts.end(), file.alerts.begin(), file.alerts.end());
}

void add_measurements_of(ContainerDraft& draft, ContainerSurface& surface, const StoredMeasurement& measurement) {
    const auto source = bytes::file_source(measurement.path);
    auto file = read_container(source);
    auto& surfaces = file.container.surfaces;
    if (measurement.channel) keep_only(*measurement.channel, measurement.path, surfaces);
    for (auto& other : surfaces)
        for (auto& topography : other.topographies) replace_given(measurement, topography);
    upgrade_all(draft, source, members_of(surfaces, file.members), surfaces);
    for (auto& other : surfaces)
        std::move(other.topographies.begin(), other.topographies.end(), std::back_inserter(surface.topographies));
}

}  // namespace setae::formats
