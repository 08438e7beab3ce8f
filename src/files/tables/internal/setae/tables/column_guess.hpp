// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setae/tables/mapping.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// Conversion of a column to the quantity of its role.
enum class Derivation {
    none,
    negative,        ///< displacement as the negative of a gap
    radius_of_area,  ///< contact radius as sqrt(A/π) of a circle with the contact's area
};

/// A column that may have a role, and why.
struct RoleCandidate {
    std::size_t column = 0;   ///< from 0
    double confidence = 0.0;  ///< 0 to 1: 0.95 for a word of the field, 0.7 for its symbol, 0.5 for only its unit
    std::string reason;       ///< such as "'load' is a word for force, mN its unit"
    Derivation derivation = Derivation::none;
    std::optional<std::string> unit{};  ///< replaces that of the header
};

/// The candidates for one column of a loop, best first.
struct RoleGuess {
    std::string role;  ///< "force", "displacement", "contact_radius" or "time"
    std::vector<RoleCandidate> candidates;
};

/// Presumed roles of the columns of a foreign table: printed with describe(), converted to a mapping with
/// mapping_from().
struct ColumnGuess {
    struct Shown {
        std::string name;
        std::string unit;
        std::vector<double> first_values;  ///< up to five, as in the file
        std::string note;                  ///< such as "text", "no unit", "all values undefined"
    };
    static constexpr const char* undefined_note = "all values undefined";

    std::string path;
    TableOptions file;  ///< layout of the table
    std::vector<Shown> columns;
    std::vector<RoleGuess> roles;
};

/// "column 2 'Load' [mN]".
[[nodiscard]] std::string label(const ColumnGuess& guess, std::size_t column);
/// The candidates of a role: "column 2 'Load' [mN] and column 3 'Force' [mN]".
[[nodiscard]] std::string labels(const ColumnGuess& guess, const RoleGuess& role);

/// Guesses the roles of columns from their names, symbols and units.
///
/// Words: force, load, normal force, F, P, FN; displacement, indentation, penetration, depth, stage, piezo, position,
/// travel, d, z, δ; gap, separation; contact radius, radius, a; contact area, A; time, t, clock, timestamp; and those
/// of German, French, Spanish, Italian, Portuguese and Dutch, with or without accents. A unit of another dimension
/// excludes a column; without words the only column in a unit of force or time is used with low confidence. Deviations,
/// set points, rates and temperatures are ignored.
[[nodiscard]] ColumnGuess guess_columns(const RawTable& table, const std::string& path, const TableOptions& file = {});

/// The guess of a file. @throws as read_raw_table.
[[nodiscard]] ColumnGuess guess_columns(const std::string& path, const TableOptions& file = {});

/// The guess as text for users: layout, each column with its first values, each role with its candidates, their
/// confidence and reasons, and the decisions to be made.
[[nodiscard]] std::string describe(const ColumnGuess& guess);

/// The mapping of a guess. `chosen` gives a column for a role and has priority over the guess: by its header ("Load"),
/// with a unit that replaces the header's ("Load[mN]"), by its position from 1 ("2", "2[mN]"); or it is an expression
/// such as "3.01 N/m * mems" or "-1 * load", whose column names are the words of the header in lower case joined with
/// '_', an unambiguous beginning, or "column2". A column without a unit is a plain number in an
/// expression: "1 uN * kraft".
/// @throws FormatError if a role has two candidates and none was chosen (the message contains both), if force, or,
/// unless the radius is in another file, both displacement and contact radius are missing, if a column has no unit, one
/// of another dimension (a mass for a force is reported as such) or contains text. A column without any number is left
/// out with a note, unless it was chosen.
[[nodiscard]] Mapping mapping_from(const ColumnGuess& guess, const ChosenColumns& chosen = {},
                                   LoopColumns wanted = LoopColumns::complete);

/// The mapping of the chosen roles only. @throws FormatError as mapping_from.
[[nodiscard]] Mapping mapping_of_chosen(const ColumnGuess& guess, const ChosenColumns& chosen);

/// Name of a column in a choice, and the same for the choice of a role.
[[nodiscard]] ChannelName channel_name(const ColumnGuess& guess, const RoleCandidate& candidate);
[[nodiscard]] ChannelName channel_chosen(const ColumnGuess& guess, const std::string& role, const std::string& text);

/// A mapping to complete, as TOML: chosen or found columns, a "?" for each unit missing in the header, and the possible
/// columns of a role. read_mapping() refuses it while it contains a "?".
/// @throws FormatError for a choice that matches no column.
[[nodiscard]] std::string mapping_template(const ColumnGuess& guess, const ChosenColumns& chosen,
                                           LoopColumns wanted = LoopColumns::complete);

/// Name of a column in expressions: "load" for 'Load [mN]', "column2" for a column without a name.
[[nodiscard]] std::string expression_name(const ColumnGuess& guess, std::size_t column);

/// Unit of force that replaces a unit of mass of a balance: "gf" for "g"; empty for another unit.
[[nodiscard]] std::string weight_unit(const std::string& unit);

/// `--column force="Load[gf]"`, and its form in a study.
[[nodiscard]] std::string column_option(const ChosenColumns& chosen);

}  // namespace setae::tables
