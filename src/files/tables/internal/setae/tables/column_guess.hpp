// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setae/tables/mapping.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// How a column gives the quantity of its role.
enum class Derivation {
    none,
    negative,        ///< displacement as the negative of a gap
    radius_of_area,  ///< contact radius as sqrt(A/π) of a circle with the contact's area
};

/// A column that may play a role, and why.
struct RoleCandidate {
    std::size_t column = 0;   ///< from 0
    double confidence = 0.0;  ///< 0 to 1: 0.95 a word of the field, 0.7 its symbol, 0.5 its unit alone
    std::string reason;       ///< such as "'load' is a word for force, mN its unit"
    Derivation derivation = Derivation::none;
    std::optional<std::string> unit{};  ///< replaces that of the header
};

/// The candidates for one column of a loop, best first.
struct RoleGuess {
    std::string role;  ///< "force", "displacement", "contact_radius" or "time"
    std::vector<RoleCandidate> candidates;
};

/// What the columns of a foreign table seem to be: shown with describe(), turned into a mapping with mapping_from().
struct ColumnGuess {
    struct Shown {
        std::string name;
        std::string unit;
        std::vector<double> first_values;  ///< up to five, as the file spells them
        std::string note;                  ///< such as "text", "no unit", "all values undefined"
    };
    static constexpr const char* undefined_note = "all values undefined";

    std::string path;
    TableOptions file;  ///< how the table was read
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
/// rules a column out; without words the only column in a unit of force or time is taken at low confidence. Deviations,
/// set points, rates and temperatures are left aside.
[[nodiscard]] ColumnGuess guess_columns(const RawTable& table, const std::string& path, const TableOptions& file = {});

/// The guess of a file. @throws as read_raw_table.
[[nodiscard]] ColumnGuess guess_columns(const std::string& path, const TableOptions& file = {});

/// The guess for a reader: how the text was read, each column with its first values, each role with its candidates,
/// their confidence and reasons, and what has to be decided.
[[nodiscard]] std::string describe(const ColumnGuess& guess);

/// The mapping a guess amounts to. `chosen` names a column for a role and overrules the guess: by its header ("Load"),
/// with a unit that replaces the header's ("Load[mN]"), by its position from 1 ("2", "2[mN]"); or it is an expression
/// such as "3.01 N/m * mems" or "-1 * load", which names columns by the words of their header in lower case joined with
/// '_', or by a beginning that no other column has, or as "column2". A column without a unit is a plain number in an
/// expression: "1 uN * kraft".
/// @throws FormatError where a role has two candidates and none was chosen (both are named), where force, or, unless
/// the radius comes from elsewhere, both displacement and contact radius are missing, where a column has no unit, one
/// of another dimension (a mass for a force is named as such) or holds text. A column without any number is left out
/// with a note, unless it was chosen.
[[nodiscard]] Mapping mapping_from(const ColumnGuess& guess, const ChosenColumns& chosen = {},
                                   LoopColumns wanted = LoopColumns::complete);

/// The mapping of the chosen roles alone. @throws FormatError as above.
[[nodiscard]] Mapping mapping_of_chosen(const ColumnGuess& guess, const ChosenColumns& chosen);

/// What a column is called where it is chosen, and the same of what was chosen for a role.
[[nodiscard]] ChannelName channel_name(const ColumnGuess& guess, const RoleCandidate& candidate);
[[nodiscard]] ChannelName channel_chosen(const ColumnGuess& guess, const std::string& role, const std::string& text);

/// A mapping to complete, as TOML: what is chosen or found, a "?" for each unit that no header states, and the columns
/// that a role may have. read_mapping() refuses it as long as a "?" is left.
/// @throws FormatError for a choice that no column has.
[[nodiscard]] std::string mapping_template(const ColumnGuess& guess, const ChosenColumns& chosen,
                                           LoopColumns wanted = LoopColumns::complete);

/// What an expression calls a column: "load" for 'Load [mN]', "column2" for one without a name of its own.
[[nodiscard]] std::string expression_name(const ColumnGuess& guess, std::size_t column);

/// What takes the place of the mass's unit where a balance showed a force: "gf" for "g"; empty for another unit.
[[nodiscard]] std::string weight_unit(const std::string& unit);

/// `--column force="Load[gf]"`, and how a study says the same.
[[nodiscard]] std::string column_option(const ChosenColumns& chosen);

}  // namespace setae::tables
