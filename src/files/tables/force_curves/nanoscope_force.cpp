// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "setae/bytes/stored_numbers.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/force_curve_formats.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/nanoscope_header.hpp"

// Force curves of Nanoscope: for each channel a section "Ciao force image list" and a block of little-endian integers,
// curve after curve, each with the approach and then the retraction, both from the deepest point of the base outwards.
// The height is the channel of the sensor, otherwise the ramp in equal steps; volts are integers times "V/LSB".
namespace setae::tables {
namespace {

constexpr std::string_view force_images = "ciao force image list";
constexpr double largest_long_step = 1e-6;  ///< [V]; for 32-bit integers: a larger step is that of their upper 16 bits

/// Integers of a channel and their scale.
struct ForceBlock {
    std::string name;
    std::uint64_t offset = 0, bytes = 2;
    std::uint64_t extend = 0, retract = 0, curves = 0;
    double step = 0.0;  ///< [V] per integer
    std::string sensitivity;

    [[nodiscard]] std::uint64_t curve_bytes() const { return bytes * (extend + retract); }
};

struct NanoscopeForce {
    ForceBlock deflection;
    std::optional<ForceBlock> height;
    double metres_per_volt = 0.0;  ///< of the height's channel
    double ramp = 0.0;             ///< [m], if there is none
    ForceCurveOptions constants;
    std::optional<MapGrid> grid;
    std::map<std::string, std::string> metadata;
};

/// `S [DeflectionError] "Deflection Error"`: the displayed name, otherwise the internal one.
std::string data_name(const std::string& data) {
    const auto quote = data.find('"'), end = data.rfind('"');
    if (quote != std::string::npos && end > quote + 1) return data.substr(quote + 1, end - quote - 1);
    const auto open = data.find('['), close = data.find(']');
    return open != std::string::npos && close != std::string::npos && close > open
               ? data.substr(open + 1, close - open - 1)
               : data;
}

std::optional<ForceBlock> block_of(const NanoscopeSection& section, const bytes::Source& source) {
    const auto *data = find(section, "image data"), *scale = find(section, "z scale");
    if (!data || !scale) return std::nullopt;
    ForceBlock block{.name = data_name(*data)};
    block.offset = nanoscope_integer(section, "data offset", source);
    block.bytes = nanoscope_integer(section, "bytes/pixel", source);
    const auto length = nanoscope_integer(section, "data length", source);
    std::string_view samples = find(section, "samps/line") ? std::string_view(*find(section, "samps/line")) : "";
    block.extend = leading<std::uint64_t>(samples).value_or(0);
    samples = trimmed(samples);
    block.retract = leading<std::uint64_t>(samples).value_or(block.extend);
    if (block.bytes != 2 && block.bytes != 4)
        throw FormatError(source.name, {},
                          fmt::format("Nanoscope: force curves of {} bytes per value, expected 2 or 4", block.bytes));
    const auto per_curve = block.extend < (1u << 24) && block.retract < (1u << 24) ? block.curve_bytes() : 0;
    if (per_curve == 0 || length < per_curve)
        throw FormatError(source.name, {},
                          fmt::format("Nanoscope: channel '{:.40}' has {} bytes for curves of {} and {} samples",
                                      block.name, length, block.extend, block.retract));
    block.curves = length / per_curve;
    if (block.offset > source.size || block.curves * per_curve > source.size - block.offset)
        throw FormatError(
            source.name, {.offset = source.size},
            fmt::format(
                "Nanoscope: the file ends here, expected the end of the force curves of '{:.40}' at byte {}; it "
                "is truncated",
                block.name, block.offset + block.curves * per_curve));
    const auto stated = nanoscope_scale(*scale);
    const auto unit =
        stated.step ? try_parse_unit(stated.step->unit.substr(0, stated.step->unit.find('/'))) : std::nullopt;
    if (!stated.step || !unit || unit->dimension != parse_unit("V").dimension || !std::isfinite(stated.step->number))
        return std::nullopt;
    block.step = stated.step->number * unit->factor;
    if (block.bytes == 4 && block.step > largest_long_step) block.step /= 65536.0;
    block.sensitivity = stated.sensitivity;
    return block;
}

/// Metres per volt of a sensitivity; empty if the header states none of that kind.
std::optional<double> metres_per_volt(const std::vector<NanoscopeSection>& sections, const std::string& name) {
    const auto soft = soft_sensitivity(sections, name);
    const auto slash = soft ? soft->unit.find('/') : std::string::npos;
    if (slash == std::string::npos) return std::nullopt;
    const auto above = try_parse_unit(plain_unit(soft->unit.substr(0, slash))),
               below = try_parse_unit(plain_unit(soft->unit.substr(slash + 1)));
    if (!above || !below || above->dimension != dimension::length || below->dimension != parse_unit("V").dimension)
        return std::nullopt;
    return soft->number * above->factor / below->factor;
}

bool names_deflection(const std::string& name) {
    const auto lower = bytes::lowered(name);
    return lower.find("deflection") != std::string::npos && lower.find("horizontal") == std::string::npos;
}

bool names_height_sensor(const std::string& name) {
    const auto lower = bytes::lowered(name);
    return lower.find("height sensor") != std::string::npos || lower.find("zsensor") != std::string::npos ||
           lower.find("z sensor") != std::string::npos;
}

/// Travel of the base [m]: volts of the ramp times the sensitivity of the piezo.
std::optional<double> ramp_of(const NanoscopeSection& image, const std::vector<NanoscopeSection>& sections) {
    const std::string* text = find(image, "ramp size");
    for (const char* key : {"ramp size", "ramp size zsweep"})
        if (!text) text = find(image, key) ? find(image, key) : find(sections, key);
    if (!text) return std::nullopt;
    const auto scale = nanoscope_scale(*text);
    const auto metres = metres_per_volt(sections, scale.sensitivity);
    if (!scale.range || !metres) return std::nullopt;
    return scale.range->number * *metres;
}

/// The grid of a force volume: curves in lines of `force/line`, the first at the lower left, as images are stored.
std::optional<MapGrid> grid_of(const std::vector<NanoscopeSection>& sections, std::uint64_t curves) {
    const auto* per_line = find(sections, "force/line");
    const auto* scan = section_named(sections, "ciao scan list");
    if (!per_line) per_line = scan ? find(*scan, "samps/line") : nullptr;
    const auto* size = scan ? find(*scan, "scan size") : nullptr;
    const auto columns = per_line ? leading_value(*per_line) : std::nullopt;
    const auto first = size ? leading_value(*size) : std::nullopt;
    if (!columns || !first || !(columns->number >= 1.0) || columns->number > 1e6 || curves < 2) return std::nullopt;
    const auto nx = static_cast<std::uint64_t>(columns->number);
    const auto second = leading_value(first->unit);
    const auto unit = try_parse_unit(plain_unit(second ? second->unit : first->unit));
    if (!unit || unit->dimension != dimension::length || curves % nx != 0) return std::nullopt;
    MapGrid grid{.columns = static_cast<Index>(nx), .rows = static_cast<Index>(curves / nx)};
    grid.width = first->number * unit->factor;
    grid.height = second ? second->number * unit->factor
                         : grid.width * static_cast<double>(grid.rows) / static_cast<double>(grid.columns);
    if (!(grid.width > 0.0) || !(grid.height > 0.0) || grid.columns * grid.rows > max_map_points) return std::nullopt;
    return grid;
}

void describe(const std::vector<NanoscopeSection>& sections, NanoscopeForce& force) {
    for (const auto& [key, name] : {std::pair{"date", "date"},
                                    {"microscope", "instrument"},
                                    {"version", "software_version"},
                                    {"trigger mode", "trigger_mode"},
                                    {"trigger channel", "trigger_channel"},
                                    {"trig threshold defl", "trigger"},
                                    {"tip radius", "tip_radius_of_file"}})
        if (const auto* value = find(sections, key); value && !value->empty()) force.metadata.emplace(name, *value);
}

NanoscopeForce force_of(const bytes::Source& source) {
    const auto sections = nanoscope_sections(source);
    NanoscopeForce force;
    const NanoscopeSection* of_deflection = nullptr;
    for (const auto& section : sections) {
        if (section.name != force_images) continue;
        const auto block = block_of(section, source);
        if (!block) continue;
        if (names_deflection(block->name) && !of_deflection) {
            force.deflection = *block;
            of_deflection = &section;
        } else if (names_height_sensor(block->name) && !force.height) {
            if (const auto metres = metres_per_volt(sections, block->sensitivity)) {
                force.height = block;
                force.metres_per_volt = *metres;
            }
        }
    }
    if (!of_deflection)
        throw FormatError(source.name, {.offset = 0},
                          "Nanoscope: force curves without a channel of deflection in volts; export them as text");
    if (force.height &&
        (force.height->extend != force.deflection.extend || force.height->retract != force.deflection.retract ||
         force.height->curves != force.deflection.curves))
        force.height.reset();
    if (!force.height) {
        const auto ramp = ramp_of(*of_deflection, sections);
        if (!ramp || !(*ramp > 0.0))
            throw FormatError(source.name, {.offset = 0},
                              "Nanoscope: force curves with neither a height sensor nor a ramp size in the header");
        force.ramp = *ramp;
    }
    force.constants.sensitivity = metres_per_volt(sections, force.deflection.sensitivity);
    if (const auto* spring = find(*of_deflection, "spring constant"))
        if (const auto value = leading_value(*spring); value && value->number > 0.0 && std::isfinite(value->number))
            force.constants.spring_constant = value->number;
    force.grid = grid_of(sections, force.deflection.curves);
    force.metadata["height_channel"] = force.height ? force.height->name : "ramp";
    describe(sections, force);
    return force;
}

/// The integers of a part of a curve in volts; the smallest integer marks missing values.
Array1D volts_of(const ForceBlock& block, std::uint64_t curve, bool extend, const bytes::Source& source) {
    const auto count = extend ? block.extend : block.retract;
    const auto begin = block.offset + curve * block.curve_bytes() + (extend ? 0 : block.bytes * block.extend);
    const auto bytes = source.bytes(begin, count * block.bytes);
    Array1D values(static_cast<Index>(count));
    for (std::uint64_t i = 0; i < count; ++i) {
        const char* at = bytes.data() + i * block.bytes;
        const double raw = block.bytes == 2 ? bytes::load<std::int16_t>(at, std::endian::little)
                                            : bytes::load<std::int32_t>(at, std::endian::little);
        const double lowest =
            block.bytes == 2 ? std::numeric_limits<std::int16_t>::min() : std::numeric_limits<std::int32_t>::min();
        values[static_cast<Index>(i)] = raw == lowest ? undefined : block.step * raw;
    }
    return values;
}

/// Number of samples before the missing ones at the far end.
Index measured(const Array1D& reading, const Array1D& height) {
    Index count = reading.size();
    while (count > 0 && (std::isnan(reading[count - 1]) || std::isnan(height[count - 1]))) --count;
    return count;
}

ForceSegment segment_of(const NanoscopeForce& force, std::uint64_t curve, bool extend, const bytes::Source& source) {
    const auto reading = volts_of(force.deflection, curve, extend, source);
    Array1D height;
    if (force.height) {
        height = volts_of(*force.height, curve, extend, source) * force.metres_per_volt;
    } else {
        const auto n = static_cast<double>(reading.size());
        height = Array1D::LinSpaced(reading.size(), force.ramp, force.ramp / n);
    }
    const auto count = measured(reading, height);
    ForceSegment segment{extend ? "extend" : "retract", height.head(count), reading.head(count), 0.0};
    if (extend) {
        segment.height.reverseInPlace();
        segment.reading.reverseInPlace();
    }
    return segment;
}

ForceCurveData curve_of(const NanoscopeForce& force, std::uint64_t curve, const bytes::Source& source) {
    ForceCurveData data;
    data.reading = Reading::volts;
    data.constants = force.constants;
    data.metadata = force.metadata;
    for (const bool extend : {true, false})
        if (auto segment = segment_of(force, curve, extend, source); segment.height.size() > 1)
            data.segments.push_back(std::move(segment));
    if (data.segments.empty())
        throw FormatError(source.name, {.offset = force.deflection.offset},
                          fmt::format("Nanoscope: force curve {} has no measured sample", curve));
    const auto& first = data.segments.front();
    const double way = first.height[first.height.size() - 1] - first.height[0];
    data.travel_sign = (way < 0.0) == (first.name == "extend") ? -1.0 : 1.0;
    if (force.grid) {
        const auto& grid = *force.grid;
        const auto column = static_cast<double>(curve % static_cast<std::uint64_t>(grid.columns)),
                   row = static_cast<double>(curve / static_cast<std::uint64_t>(grid.columns));
        data.x = ((column + 0.5) / static_cast<double>(grid.columns) - 0.5) * grid.width;
        data.y = ((row + 0.5) / static_cast<double>(grid.rows) - 0.5) * grid.height;
    }
    return data;
}

}  // namespace

bool is_nanoscope_force(const bytes::Source& source) {
    if (!is_nanoscope(source.head(32))) return false;
    try {
        return section_named(nanoscope_sections(source), force_images) != nullptr;
    } catch (const FormatError&) {
        return false;
    }
}

ForceCurveFile open_nanoscope_force(const bytes::Source& source) {
    const auto force = std::make_shared<const NanoscopeForce>(force_of(source));
    ForceCurveFile file{.grid = force->grid, .numbers = {}, .read = {}};
    for (std::uint64_t k = 0; k < std::min<std::uint64_t>(force->deflection.curves, max_map_points); ++k)
        file.numbers.push_back(static_cast<long>(k));
    file.read = [force, source](long number) { return curve_of(*force, static_cast<std::uint64_t>(number), source); };
    return file;
}

}  // namespace setae::tables
