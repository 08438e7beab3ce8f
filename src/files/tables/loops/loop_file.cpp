// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/loop_file.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/source.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {
namespace {

constexpr std::string_view format_line = "# format: setae loop", version_line = "# version: 1";

bool is_own_key(const std::string& key) {
    return key == "format" || key == "version" || key == "file" || key == "header" || key == "mapping";
}

bool is_key(std::string_view key) {
    return !key.empty() && key.front() >= 'a' && key.front() <= 'z' && std::all_of(key.begin(), key.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const auto length = utf8_length(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

const LoopKey* known_key(std::string_view name) {
    for (const auto& key : loop_keys())
        if (key.name == name) return &key;
    return nullptr;
}

/// SI value of a known quantity. @throws InvalidArgument.
Estimate quantity(const LoopKey& key, const std::string& value) {
    try {
        return key.uncertain ? parse_uncertain_quantity(value, *key.expected)
                             : Estimate{parse_quantity(value, *key.expected)};
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(fmt::format("{}: {}", key.name, error.what()));
    }
}

void require_entry(const std::string& key, const std::string& value) {
    if (!is_key(key))
        throw InvalidArgument(
            fmt::format("'{}' is not a key of a loop file; use lower-case letters, digits and _, beginning with a "
                        "letter",
                        key));
    if (value.find_first_of("\r\n") != std::string::npos || trimmed(value) != value ||
        value.find('\0') != std::string::npos)
        throw InvalidArgument(
            fmt::format("the value of '{}' has line breaks or outer blanks; write it on one line", key));
    if (!is_utf8(value)) throw InvalidArgument(fmt::format("the value of '{}' is not UTF-8", key));
    const auto* known = known_key(key);
    if (known && known->expected) (void)quantity(*known, value);
}

/// State while a file is read line by line.
struct Reader {
    std::string path;
    std::vector<std::string_view> lines;
    std::size_t line = 0;  ///< from 0

    [[noreturn]] void fail(const std::string& what) const { throw FormatError(path, {.line = line + 1}, what); }
};

void read_entry(Reader& reader, Table& table) {
    const auto text = trimmed(reader.lines[reader.line].substr(1));
    const auto colon = text.find(':');
    if (colon == std::string_view::npos) return;  // a comment
    const std::string key(trimmed(text.substr(0, colon))), value(trimmed(text.substr(colon + 1)));
    if (!is_key(key)) return;
    if (!table.metadata.emplace(key, value).second) reader.fail(fmt::format("key '{}' is given twice; keep one", key));
    if (key == "format" || key == "version") return;
    try {
        require_entry(key, value);
    } catch (const InvalidArgument& error) {
        reader.fail(error.what());
    }
}

void read_names(Reader& reader, Table& table) {
    if (reader.line == reader.lines.size())
        reader.fail("no row of column names such as 'time [s],force [N],displacement [m]'");
    std::vector<std::string_view> cells;
    split_cells(reader.lines[reader.line], ',', cells);
    std::set<std::string> names;
    for (const auto cell : cells) {
        const auto parsed = parse_header_cell(cell);
        const auto unit = try_parse_unit(parsed.unit);
        if (!unit && !parsed.unit.empty() && parsed.unit != "°C")
            reader.fail(fmt::format("column '{}' has the unknown unit '{}'", parsed.name, parsed.unit));
        if (!names.insert(parsed.name).second) reader.fail(fmt::format("two columns are named '{}'", parsed.name));
        table.columns.push_back({parsed.name, unit ? si_unit(unit->dimension) : parsed.unit, {}});
    }
}

void read_numbers(Reader& reader, Table& table) {
    std::vector<double> factors;
    std::vector<std::string_view> cells;
    split_cells(reader.lines[reader.line++], ',', cells);
    for (const auto cell : cells) {
        const auto unit = try_parse_unit(parse_header_cell(cell).unit);
        factors.push_back(unit ? unit->factor : 1.0);
    }
    std::vector<std::vector<double>> values(factors.size());
    for (; reader.line < reader.lines.size(); ++reader.line) {
        const auto text = trimmed(reader.lines[reader.line]);
        if (text.empty() || text.front() == '#') continue;
        split_cells(text, ',', cells);
        if (cells.size() != values.size())
            reader.fail(fmt::format("{} cells, expected {}, one per name; the file may be truncated here", cells.size(),
                                    values.size()));
        for (std::size_t k = 0; k < cells.size(); ++k) {
            double value = undefined;
            if (!parse_cell(cells[k], '.', value))
                reader.fail(fmt::format("'{:.40}' for {} is not a number", cells[k], table.columns[k].name));
            values[k].push_back(value * factors[k]);
        }
    }
    if (values.front().empty()) reader.fail("no rows of numbers follow the names");
    for (std::size_t k = 0; k < values.size(); ++k)
        table.columns[k].values = Eigen::Map<const Array1D>(values[k].data(), static_cast<Index>(values[k].size()));
}

void require_loop(const Table& table) {
    try {
        require_loop_columns(table, "loop");
    } catch (const FormatError& error) {
        throw InvalidArgument(error.what());
    }
}

/// Checks that each header cell is read with its name and unit.
void require_columns(const Table& table) {
    std::set<std::string> names;
    for (const auto& column : table.columns) {
        const auto unit = try_parse_unit(column.unit);
        if (!column.unit.empty() && column.unit != "°C" && (!unit || si_unit(unit->dimension) != column.unit))
            throw InvalidArgument(
                fmt::format("column '{}' has the unit '{}', expected one of SI", column.name, column.unit));
        const auto cell =
            parse_header_cell(column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit));
        if (column.name.empty() || column.name.front() == '#' || cell.name != column.name || cell.unit != column.unit ||
            !is_utf8(column.name))
            throw InvalidArgument(fmt::format(
                "column name '{}' cannot be written: it is empty, or would be read differently", column.name));
        if (!names.insert(column.name).second)
            throw InvalidArgument(fmt::format("two columns are named '{}'", column.name));
    }
}

}  // namespace

const std::vector<LoopKey>& loop_keys() {
    const Expected poisson_ratio{dimension::none, domain::poisson_ratio};
    static const std::vector<LoopKey> keys{
        {"sphere_radius", "radius of curvature of the sphere or lens", positive(dimension::length), true},
        {"lens_youngs_modulus", "Young's modulus of the soft body, where known", positive(dimension::pressure), true},
        {"lens_poisson_ratio", "Poisson's ratio of the soft body", poisson_ratio, true},
        {"lens_height", "height of the soft lens above its mount", positive(dimension::length), true},
        {"layer_thickness", "thickness of the soft body where it is a layer on a rigid base",
         positive(dimension::length), true},
        {"counter_youngs_modulus", "Young's modulus of the body it is pressed against", positive(dimension::pressure)},
        {"counter_poisson_ratio", "its Poisson's ratio", poisson_ratio},
        {"machine_stiffness", "stiffness of the force sensor and frame, where displacement is the stage's",
         positive(dimension::stiffness), true},
        {"spring_constant", "stiffness of the spring that senses the force", positive(dimension::stiffness)},
        {"camera_clock_offset", "added to the camera's times to give the times of the force record", dimension::time},
        {"camera_clock_offset_error", "its standard error", non_negative(dimension::time)},
        {"camera_frame_interval", "time from frame to frame", positive(dimension::time)},
        {"camera_pixel_size", "width of a pixel on the sample", positive(dimension::length)},
        {"relative_humidity", "of the air, as a share of 1 or in %", non_negative(dimension::none)},
        {"surface", "name of the hard, rough body's surface"},
        {"elastomer", "name of the soft material, with its batch"},
        {"stage", "the stage that moves, what its displacement is counted from"},
        {"force_sensor", "what measured the force, with its calibration"},
        {"camera", "what measured the contact radius"},
        {"camera_clock", "whose clock the radii came from and how it was brought onto the force's"},
        {"spot", "place on the surface"},
        {"lens", "which lens or sphere"},
        {"date", "of the measurement, ISO 8601"},
        {"operator", "who measured"},
        {"source", "the file the columns came from"},
        {"comment", "anything else"}};
    return keys;
}

std::string as_loop_file(const Table& table, const std::map<std::string, std::string>& metadata) {
    require_loop(table);
    std::string text = fmt::format("{}\n{}\n", format_line, version_line);
    for (const auto& [key, value] : metadata) {
        if (is_own_key(key)) continue;
        require_entry(key, value);
        text += fmt::format("# {}:{}{}\n", key, value.empty() ? "" : " ", value);
    }
    require_columns(table);
    return text + as_csv(table);
}

void write_loop(const std::string& path, const Table& table, const std::map<std::string, std::string>& metadata) {
    bytes::write_whole_file(path, as_loop_file(table, metadata));
}

std::map<std::string, std::string> loop_metadata(const Table& table) {
    std::map<std::string, std::string> kept;
    for (const auto& [key, value] : table.metadata) {
        if (is_own_key(key)) continue;
        try {
            require_entry(key, value);
        } catch (const InvalidArgument&) {
            continue;
        }
        kept.emplace(key, value);
    }
    return kept;
}

bool is_loop_file(std::string_view head) {
    const auto line = head.substr(0, head.find('\n'));
    return trimmed(line) == format_line;
}

bool is_loop_file(const bytes::Source& source) {
    constexpr std::uint64_t beyond_first_line = 64;
    return is_loop_file(source.head(beyond_first_line));
}

Table read_loop(const std::string& path) {
    const auto text = bytes::decoded(bytes::read_file(path), bytes::Encoding::utf8);
    Reader reader{path, bytes::split_lines(text)};
    if (!is_loop_file(text))
        throw FormatError(
            path, {.line = 1},
            fmt::format("not a loop file: it does not begin with '{}'; import other tables with a mapping",
                        format_line));
    Table table;
    for (; reader.line < reader.lines.size(); ++reader.line) {
        const auto line = trimmed(reader.lines[reader.line]);
        if (line.empty()) continue;
        if (line.front() != '#') break;
        read_entry(reader, table);
    }
    if (table.metadata["version"] != "1")
        reader.fail(fmt::format("version '{}' of the loop format is unknown; expected 1", table.metadata["version"]));
    read_names(reader, table);
    read_numbers(reader, table);
    table.metadata["file"] = path;
    require_loop_columns(table, path);
    return table;
}

std::optional<Estimate> loop_quantity(const Table& loop, const std::string& key) {
    const auto* known = known_key(key);
    if (!known || !known->expected) throw InvalidArgument(fmt::format("'{}' is not a quantity of a loop file", key));
    const auto entry = loop.metadata.find(key);
    if (entry == loop.metadata.end()) return std::nullopt;
    return quantity(*known, entry->second);
}

}  // namespace setae::tables
