// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setae/tables/mapping.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// A column that may play a role, and why.
struct RoleCandidate {
    std::size_t column = 0;   ///< from 0
    double confidence = 0.0;  ///< 0 to 1: 0.95 a word of the field, 0.7 its symbol, 0.5 its unit alone
    std::string reason;       ///< such as "'load' is a word for force, mN its unit"
    bool from_area = false;   ///< contact radius as sqrt(A/π) of a circle with the contact's area
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
    std::string path;
    TableOptions file;  ///< how the table was read
    std::vector<Shown> columns;
    std::vector<RoleGuess> roles;
};

/// Guesses the roles of columns from their names, symbols and units.
///
/// Words: force, load, normal force, F, P, FN; displacement, indentation, penetration, depth, stage, piezo, position,
/// travel, d, z, δ; contact radius, radius, a; contact area, A; time, t, clock, timestamp. A unit of another dimension
/// rules a column out; without words the only column in a unit of force or time is taken at low confidence. Deviations,
/// set points, rates and temperatures are left aside.
[[nodiscard]] ColumnGuess guess_columns(const RawTable& table, const std::string& path, const TableOptions& file = {});

/// The guess of a file. @throws as read_raw_table.
[[nodiscard]] ColumnGuess guess_columns(const std::string& path, const TableOptions& file = {});

/// The guess for a reader: how the text was read, each column with its first values, each role with its candidates,
/// their confidence and reasons, and what has to be decided.
[[nodiscard]] std::string describe(const ColumnGuess& guess);

/// The mapping a guess amounts to. `chosen` names a column for a role, by its header or by its position from 1, and
/// overrules the guess; or it is an expression such as "3.01 N/m * mems", which names columns by the words of their
/// header in lower case joined with '_', or by a beginning that no other column has, or as "column2".
/// @throws FormatError where a role has two candidates and none was chosen (both are named), where force, or, unless
/// the radius comes from elsewhere, both displacement and contact radius are missing, where a column has no unit or
/// holds text. A column without any number is left out with a note, unless it was chosen.
[[nodiscard]] Mapping mapping_from(const ColumnGuess& guess, const std::map<std::string, std::string>& chosen = {},
                                   LoopColumns wanted = LoopColumns::complete);

}  // namespace setae::tables
