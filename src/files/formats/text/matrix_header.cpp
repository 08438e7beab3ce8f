// SPDX-License-Identifier: GPL-3.0-or-later
#include "matrix_header.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/dialect.hpp"

namespace setae::formats {
namespace {

enum class Flavour { plain, spip, wyko };

constexpr const char* wyko_unit = "unit of numbers";

using Labels = std::initializer_list<std::string_view>;

// Gwyddion writes its labels in the language of the user
bool is_channel(std::string_view key) {
    for (const auto label : Labels{"channel", "kanal", "kanál", "canal", "canale", "Канал", "チャネル", "채널"})
        if (key == label) return true;
    return false;
}
bool is_width(std::string_view key) {
    for (const auto label : Labels{"width", "breite", "largeur", "anchura", "larghezza", "largura", "Šířka", "Ширина",
                                   "幅", "폭", "x-length"})
        if (key == label) return true;
    return false;
}
bool is_height(std::string_view key) {
    for (const auto label :
         Labels{"height", "höhe", "hauteur", "altura", "altezza", "výška", "Высота", "高さ", "높이", "y-length"})
        if (key == label) return true;
    return false;
}
bool is_value_unit(std::string_view key) {
    for (const auto label :
         Labels{"value units", "werteinheiten", "einheiten", "unités", "unidades de valor", "unità valore",
                "jednotky hodnot", "Единицы измерения", "値の単位", "값 단위", "z-unit", "unit data"})
        if (key == label) return true;
    return false;
}

/// Units of lengths may be on separate lines, below the lengths: all lines are read before interpretation.
struct Gathered {
    MatrixHeader header;
    Flavour flavour = Flavour::plain;
    std::array<std::string, 2> length, pixel, unit;
    std::optional<double> bit_to_nm;
};

class Reader {
public:
    Reader(const bytes::Source& source, const MatrixHeader& before) : source_(source) {
        gathered_.header = before;
        if (before.attributes.contains("dialect") && before.attributes.at("dialect") == "Wyko")
            gathered_.flavour = Flavour::wyko;
    }

    void take(std::string_view line) {
        if (line.starts_with("Wyko ASCII Data File Format")) return begin_wyko(line);
        if (gathered_.flavour == Flavour::wyko) return take_wyko(line);
        while (!line.empty() && (line.front() == '#' || line.front() == ';' || line.front() == '%'))
            line = trimmed(line.substr(1));
        if (take_counts(line) || take_cells(line)) return;
        auto at = line.find_first_of("=:");
        std::size_t width = 1;
        if (const auto wide = line.find("："); wide < at) at = wide, width = 3;  // full-width colon
        if (at == std::string_view::npos) return;
        take_entry(bytes::lowered(trimmed(line.substr(0, at))), trimmed(line.substr(at + width)));
    }

    [[nodiscard]] MatrixHeader finished() {
        auto& header = gathered_.header;
        if (gathered_.flavour == Flavour::wyko) return finish_wyko(), header;
        if (gathered_.flavour == Flavour::spip) {
            for (auto& unit : gathered_.unit)
                if (unit.empty()) unit = "nm";  // of SPIP lengths
            if (header.unit.empty() && gathered_.bit_to_nm) {
                header.unit = "nm";
                header.factor = *gathered_.bit_to_nm;
            }
        }
        if (gathered_.unit[1].empty()) gathered_.unit[1] = gathered_.unit[0];
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (!gathered_.length[axis].empty())
                header.length[axis] = length(gathered_.length[axis], gathered_.unit[axis]);
            if (!gathered_.pixel[axis].empty())
                header.pixel[axis] = length(gathered_.pixel[axis], gathered_.unit[axis]);
        }
        const bool sized = !gathered_.length[0].empty() && !gathered_.length[1].empty(),
                   counted = header.nx && header.ny;
        header.is_map =
            header.is_map || sized || counted || gathered_.flavour == Flavour::spip || !gathered_.pixel[0].empty();
        return header;
    }

private:
    [[noreturn]] void broken(const std::string& what) const {
        throw FormatError(source_.name, {.line = 1}, "header of a text matrix: " + what);
    }

    [[nodiscard]] double number(std::string_view text) const {
        std::string pointed(text.substr(0, text.find_first_of(" \t")));
        std::replace(pointed.begin(), pointed.end(), ',', '.');
        double value = 0.0;
        if (!bytes::parse_cell(pointed, '.', value) || !std::isfinite(value))
            broken(fmt::format("'{:.40}', expected a number", text));
        return value;
    }

    [[nodiscard]] Index count(std::string_view text) const {
        const double value = number(text);
        if (!(value >= 1.0) || value > 2147483648.0 || value != std::floor(value))
            broken(fmt::format("'{:.40}', expected a number of points", text));
        return static_cast<Index>(value);
    }

    /// [m]; empty if neither the text nor the header contains the unit.
    [[nodiscard]] std::optional<double> length(std::string text, const std::string& unit) const {
        std::replace(text.begin(), text.end(), ',', '.');
        double value = 0.0;
        const bool bare = bytes::parse_cell(text, '.', value);
        if (bare && unit.empty()) return std::nullopt;
        try {
            value = bare ? value * unit_factor(unit, dimension::length) : parse_quantity(text, dimension::length);
        } catch (const InvalidArgument& error) {
            broken(fmt::format("a size: {}", error.what()));
        }
        if (!(value > 0.0) || !std::isfinite(value))
            broken(fmt::format("a size of '{}', expected a positive length", text));
        return value;
    }

    /// "h=305 w=75": lines and values per line.
    bool take_counts(std::string_view line) {
        std::vector<std::string_view> words;
        tables::split_cells(line, ' ', words);
        if (words.size() != 2 || !words[0].starts_with("h=") || !words[1].starts_with("w=")) return false;
        gathered_.header.ny = count(words[0].substr(2));
        gathered_.header.nx = count(words[1].substr(2));
        return true;
    }

    /// "XY calibration","1.382","um/pixel" and similar lines at the beginning of tables of Keyence's and other confocal
    /// microscopes; true for a line of two or three cells whose first is one of these keys.
    bool take_cells(std::string_view line) {
        for (const char separator : {',', ';', '\t'}) {
            std::vector<std::string_view> cells;
            tables::split_cells(line, separator, cells);
            while (cells.size() > 2 && cells.back().empty()) cells.pop_back();
            if (cells.size() < 2 || cells.size() > 3) continue;
            std::vector<std::string> texts;
            for (const auto cell : cells) texts.push_back(without_quotes(cell));
            if (take_confocal(bytes::lowered(texts[0]), texts[1], texts.size() > 2 ? texts[2] : std::string()))
                return true;
        }
        return false;
    }

    static std::string without_quotes(std::string_view cell) {
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
        return std::string(trimmed(cell));
    }

    bool take_confocal(const std::string& key, const std::string& value, std::string unit) {
        auto& header = gathered_.header;
        if (key == "xy calibration" || key == "x calibration" || key == "y calibration") {
            unit = unit.substr(0, unit.find('/'));  // "um/pixel"
            const auto text = unit.empty() ? value : value + " " + unit;
            if (key.front() == 'x') gathered_.pixel[0] = text;
            if (key != "x calibration") gathered_.pixel[1] = text;
        } else if (key == "horizontal") {
            header.nx = count(value);
        } else if (key == "vertical") {
            header.ny = count(value);
        } else if (key == "unit") {
            header.unit = value;
        } else if (key == "output image data") {
            header.name = value;
            header.heights = bytes::lowered(value).find("height") != std::string::npos;
        } else if (key == "model" || key == "date and time" || key == "data name" || key == "comment" ||
                   key == "minimum value" || key == "maximum value" || key == "file name") {
            if (!value.empty()) header.attributes.insert_or_assign(key, value);
        } else {
            return false;
        }
        return true;
    }

    void take_entry(const std::string& key, std::string_view value) {
        auto& header = gathered_.header;
        const std::string text(value);
        if (is_channel(key)) {
            header.name = text;
        } else if (is_width(key)) {
            gathered_.length[0] = text;
        } else if (is_height(key)) {
            gathered_.length[1] = text;
        } else if (is_value_unit(key)) {
            header.unit = text;
        } else if (key == "x-pixels" || key == "nx") {
            header.nx = count(value);
        } else if (key == "y-pixels" || key == "ny") {
            header.ny = count(value);
        } else if (key == "x-unit" || key == "unit x") {
            gathered_.unit[0] = text;
        } else if (key == "y-unit" || key == "unit y") {
            gathered_.unit[1] = text;
        } else if (key == "pixel size") {
            gathered_.pixel = {text, text};
        } else if (key == "scale x") {
            gathered_.pixel[0] = text;
        } else if (key == "scale y") {
            gathered_.pixel[1] = text;
        } else if (key.starts_with("height conversion factor (->") && key.ends_with(')')) {
            header.unit = trimmed(std::string_view(key).substr(28, key.size() - 29));
            header.factor = number(value);
        } else if (key == "bit2nm") {
            gathered_.bit_to_nm = number(value);
        } else if (key == "voidpixels") {
            header.void_map = number(value) > 0.0;
        } else if (key == "file format" && bytes::lowered(value) == "ascii") {
            gathered_.flavour = Flavour::spip;
            header.attributes["dialect"] = "SPIP";
        } else if (!key.empty() && key.size() <= 60 && !text.empty()) {
            header.attributes.insert_or_assign(key, text);
        }
    }

    void begin_wyko(std::string_view line) {
        gathered_.flavour = Flavour::wyko;
        auto& header = gathered_.header;
        header.is_map = header.lines_are_columns = true;
        header.attributes["dialect"] = "Wyko";
        std::vector<std::string_view> words;
        tables::split_cells(line, ' ', words);
        if (words.size() >= 7 && words[6] == "1")
            header.attributes[wyko_unit] = "nm";  // otherwise multiples of the wavelength
    }

    /// "name TAB value" for the two sizes; "name TAB type TAB length TAB value" for the others, without value above
    /// numbers.
    void take_wyko(std::string_view line) {
        std::vector<std::string_view> cells;
        tables::split_cells(line, '\t', cells);
        auto& header = gathered_.header;
        const auto& key = cells.front();
        if (cells.size() < 2 || key.empty() || key == "Block Name") return;
        const auto value = cells.size() > 3 ? cells[3] : cells[1];
        if (key == "X Size") header.nx = count(value);
        else if (key == "Y Size") header.ny = count(value);
        else if (key == "Wavelength") header.attributes["wavelength [nm]"] = fmt::format("{}", std::abs(number(value)));
        else if (key == "Mult") header.attributes["mult"] = fmt::format("{}", number(value));
        else if (key == "Pixel_size") header.attributes["pixel size [mm]"] = fmt::format("{}", std::abs(number(value)));
        else if (key == "Aspect") header.attributes["aspect"] = fmt::format("{}", number(value));
        else if (key == "Title" && !value.empty()) header.attributes["title"] = std::string(value);
        else if (cells.size() < 4 || value.empty()) block(key);
        else if (key.size() < 60) header.attributes.insert_or_assign(std::string(key), std::string(value));
    }

    void block(std::string_view name) {
        auto& header = gathered_.header;
        header.heights = name == "OPD" || name == "SAMPLE_DATA" || name == "RAW_DATA" || name == "RAW DATA";
        header.name = name;
    }

    void finish_wyko() {
        auto& header = gathered_.header;
        const auto entry = [&](const char* key) -> std::optional<double> {
            const auto found = header.attributes.find(key);
            return found == header.attributes.end() ? std::nullopt : std::optional(number(found->second));
        };
        if (!header.heights) {
            header.unit.clear();
            header.factor = 1.0;
        } else if (header.attributes.contains(wyko_unit)) {
            header.unit = "nm";
            header.factor = 1.0;
        } else if (const auto wavelength = entry("wavelength [nm]")) {
            const double multiplier = entry("mult").value_or(1.0);
            if (multiplier == 0.0) broken("a multiplier of 0");
            header.unit = "nm";
            header.factor = *wavelength / multiplier;
        }
        if (const auto pixel = entry("pixel size [mm]"); pixel && *pixel > 0.0) {
            const double aspect = entry("aspect").value_or(1.0);
            header.pixel = {*pixel * units::mm, *pixel * std::abs(aspect == 0.0 ? 1.0 : aspect) * units::mm};
        }
    }

    const bytes::Source& source_;
    Gathered gathered_;
};

}  // namespace

bool begins_numbers(std::string_view line, const MatrixHeader& before) {
    const auto dialect = before.attributes.find("dialect");
    if (dialect != before.attributes.end() && dialect->second == "Wyko")
        return std::count(line.begin(), line.end(), '\t') >= 2;
    if (!line.starts_with('#')) return false;
    const auto entry = trimmed(line.substr(1));
    const auto key = bytes::lowered(trimmed(entry.substr(0, entry.find_first_of("=:"))));
    return is_channel(key) || is_width(key);
}

MatrixHeader parse_matrix_header(const std::vector<std::string>& lines, const bytes::Source& source,
                                 const MatrixHeader& before) {
    Reader reader(source, before);
    for (const auto& line : lines) reader.take(line);
    return reader.finished();
}

}  // namespace setae::formats
