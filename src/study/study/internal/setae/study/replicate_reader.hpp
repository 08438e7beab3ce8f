// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "setae/statistics/replicate_data.hpp"

namespace setae::study {

/// Rows to be left out: those whose columns contain these texts; "file" also matches a path's last part, "line" the
/// line's number.
struct ExclusionRule {
    std::map<std::string, std::string> conditions;  ///< column to text, one at least
    std::string reason;
    std::string where;  ///< for messages: the option's text, or file and line
};

/// "file=a.csv;spot=2;reason=dust on the lens".
/// @throws InvalidArgument for a part without '=', no condition, no reason.
[[nodiscard]] ExclusionRule parse_exclusion(const std::string& text);

/// A file of exclusions: TOML with tables [[exclude]], or CSV with a column "reason"; an empty cell is no condition.
/// @throws FileError; FormatError with the line of an exclusion without reason or condition.
[[nodiscard]] std::vector<ExclusionRule> read_exclusions(const std::string& path);

/// Definition of replicates by rows of tables.
struct ReplicateColumns {
    std::vector<std::string> group_by;  ///< outermost first; empty: those of surface, lens, spot that there are
    std::string quantity = "W";         ///< W, E*, E_loss, F_po, or a column's name
    std::string value_column;           ///< in place of the column of `quantity`
    std::string error_column;           ///< in place of its column of the standard error
    std::string unit;                   ///< where the header has none
    /// selected rows, where the tables have such columns; no method, or "primary": those with "yes" in a column
    /// "primary"
    std::string method, branch, elastomer;
};

/// A row that could not be used, with its place "path:line".
struct BadRow {
    std::string place, reason;
};

/// Values from tables, and the rows that are no values.
struct ReplicateTables {
    statistics::ReplicateData data;
    std::vector<BadRow> bad_rows;
};

/// Reads one quantity of tidy CSV tables: one row per fit, names with units in the header, "W [mJ/m2]"; separators are
/// commas, semicolons or tabs; including those of `setae jkr fit --tidy` and `setae jkr energy --tidy`. In a table with
/// contacts and their cycles the contacts are used. Standard errors are in a column "NAME standard_error",
/// "NAME_standard_error", "NAME_se", "NAME stderr" or "standard_error NAME"; without one they are unknown. Rows without
/// a number or a label are bad rows, the others are used.
/// @throws FileError; FormatError for a table without the requested columns or without units; InvalidArgument where
/// several methods or branches remain, for an exclusion that no row meets, a row met by two; UndefinedDataError where
/// no row is left.
[[nodiscard]] ReplicateTables read_replicates(const std::vector<std::string>& paths, const ReplicateColumns& columns,
                                              const std::vector<ExclusionRule>& exclusions);

}  // namespace setae::study
