// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "setae/output/json.hpp"

namespace setae::report {

/// A unit numbers are shown in: shown number = SI value / factor.
struct DisplayUnit {
    std::string name;  ///< as setae spells units
    double factor = 1.0;
};

/// The unit with the prefix that puts the largest of the values into [1, 1000), as far as there is one.
[[nodiscard]] DisplayUnit display_unit(const std::string& si_unit, double largest);

/// A number for readers: fixed point with so many decimals; from 10⁵, and below 10⁻³ where more than six decimals were
/// needed, four digits times a power of ten, "1.234×10⁻⁷".
[[nodiscard]] std::string shown(double value, int decimals);

/// Decimals that show two digits of a standard error > 0, else four digits of the value.
[[nodiscard]] int decimals_of(double value, double standard_error);

/// A JSON pointer and a path below it: "/surfaces/A" and "rms_height/value".
[[nodiscard]] std::string joined(const std::string& pointer, const std::string& path);

/// A JSON pointer and a key given by a user, with special characters of pointers escaped: "/surfaces" and "A/B" are
/// "/surfaces/A~1B".
[[nodiscard]] std::string named(const std::string& pointer, const std::string& key);

/// The entry a pointer names; null where there is none.
[[nodiscard]] const output::Json& entry(const output::Json& study, const std::string& pointer);

/// A number of the study with its JSON pointer: <span data-pointer="…" data-value="full precision">shown</span>.
[[nodiscard]] std::string number_html(const output::Json& study, const std::string& pointer, const DisplayUnit& unit,
                                      int decimals, const std::string& part = "value");

/// A quantity within a sentence: "37.09 ± 2.10 mJ m⁻² (95 % interval 32.62 to 41.56 mJ m⁻²)".
[[nodiscard]] std::string quantity_html(const output::Json& study, const std::string& pointer,
                                        bool with_interval = true);

struct TextCell {
    std::string text;
};
/// A sentence, set as prose() does.
struct ProseCell {
    std::string text;
};
/// An object with "value" and, where they exist, "standard_error" and "interval".
struct QuantityCell {
    std::string pointer;
};
/// A bare number, such as n.
struct NumberCell {
    std::string pointer;
};
/// An object with "lower" and "upper".
struct BandCell {
    std::string pointer;
};
using Cell = std::variant<TextCell, ProseCell, QuantityCell, NumberCell, BandCell>;

struct Column {
    std::string heading;  ///< markup of figures::Axis::quantity
    std::string unit;     ///< SI, of its numbers; empty for texts
};

/// Largest number of rows of a table, entries of a list and warnings of a kind in a page; files of results contain all.
inline constexpr std::size_t max_rows = 200;
/// Experiments whose numbers a page holds: each has about a hundred.
inline constexpr std::size_t max_experiments = 40;

/// A table of numbers of the study.
struct DataTable {
    std::string identifier;  ///< no other table of a page has it
    std::string title;
    std::string note;  ///< HTML: content of the note
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;
    bool open = false;                ///< unfolded to begin with
    std::string file = "study.json";  ///< file of the results with every row
    std::size_t most = max_rows;      ///< rows that are shown
};

/// A fold "table-IDENTIFIER": a note, the table in a region that scrolls, with buttons that sort and copy. For more
/// rows than are shown it states this, with the file that has all. Empty without rows.
[[nodiscard]] std::string as_html(const DataTable& table, const output::Json& study);

}  // namespace setae::report
