// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/table.hpp"

namespace setae::tables {

/// Options for a text table; without them the layout is found from the text.
struct TableOptions {
    bytes::Encoding encoding = bytes::Encoding::detect;  ///< byte order mark, otherwise UTF-8 if valid, otherwise
                                                         ///< latin-1
    std::optional<char> separator;                       ///< a tab, ',', ';', or ' ' for runs of blanks
    std::optional<char> decimal_point;                   ///< '.' or ','
    std::optional<std::string> header_end;               ///< the line after which numbers begin, such as "eoh"
    std::optional<std::string> sheet;                    ///< of a workbook; otherwise the first with a table

    friend bool operator==(const TableOptions&, const TableOptions&) = default;
};

/// A table as in the file: names and units of the header (empty if missing), numbers unconverted.
struct RawTable {
    struct RawColumn {
        std::string name;
        std::string unit;
        Array1D values;
        std::string
            text;  ///< the first cell that is no number, with its place, if the column contains text; values are NaN
    };
    std::vector<RawColumn> columns;
    std::vector<std::string> header;              ///< lines before the numbers, decoded to UTF-8
    std::map<std::string, std::string> metadata;  ///< of header lines "# key: value"
    char separator = ' ';
    char decimal_point = '.';
};

/// Numbers in columns with a header, as in the file.
///
/// Separators are tabs, commas, semicolons or blanks, the decimal sign is a point or a comma; both are chosen so that
/// most lines are regular. Names are in the last header line with as many cells as columns, units next to them as
/// "force [mN]", "force (mN)", "force / mN", "force in mN", "force_mN", "force, mN" or "force mN", or in a separate
/// row. Cells may be in quotes, with separators in them. An empty cell, "nan", "-" and "bad" are undefined; columns of
/// text are kept as names and marked. Thousands may be grouped ("1,234.5", "1.234,5", "1'234.5", "1 234,5"). Commas
/// that may group thousands as well as begin decimals ("1,234" without a decisive cell) are refused. Rows with twice as
/// many cells as names at commas are refused, too. A workbook (.xlsx) is read by read_spreadsheet.
/// @throws FileError; FormatError with the line of a row with another number of columns.
[[nodiscard]] RawTable read_raw_table(const bytes::Source& source, const TableOptions& options = {});

/// A raw table in SI. A column without unit keeps its numbers and has the empty unit. A column with an unknown unit
/// (such as °C) keeps its numbers and the spelling of the file. metadata["header"] contains the header lines, further
/// keys those of lines "# key: value".
[[nodiscard]] Table table_in_si(const RawTable& raw, const std::string& path);
/// The table of a file in SI.
[[nodiscard]] Table read_table(const std::string& path, const TableOptions& options = {});

/// Required columns of a loop, in addition to the force.
enum class LoopColumns {
    complete,      ///< displacement or contact radius
    force_record,  ///< none: the contact radius is in another file
};

/// Columns of a file chosen for a loop: {"force", "Load"}, {"force", "2"}, {"force", "Load[mN]"}, whose unit replaces
/// that of the header, or expressions such as {"force", "-1 * load"}.
using ChosenColumns = std::map<std::string, std::string>;

/// Origin of a column of a loop, in the form of a choice.
struct ChannelName {
    std::string column;      ///< of the file, such as "load"; empty if computed from several columns
    std::string unit;        ///< unit of that column, as used
    std::string expression;  ///< such as "load", "kraft[uN]", "-1 * gap"
};

/// By the names force, displacement, contact_radius and time.
using ChannelNames = std::map<std::string, ChannelName>;

/// Columns of a loop, and their origin.
struct LoopTable {
    Table table;
    ChannelNames channels;
    std::vector<std::string> taken;  ///< one sentence per column recognised by words, such as "contact_radius from …"
    std::vector<std::string> unused;  ///< names of unused columns
};

/// A loop: column "force" [N] and "displacement" [m] or "contact_radius" [m], optionally "time" [s], in SI. Names are
/// compared without regard to case; a column with another name is used if it is the only one that matches by words and
/// units, as `setae jkr import` recognises it ("contact radius [um]", "load [mN]"). Chosen columns have priority.
/// @throws FormatError with the missing column or unit and the choice that supplies it, also for a table without
/// forces.
[[nodiscard]] LoopTable read_loop_table(const std::string& path, LoopColumns wanted = LoopColumns::complete,
                                        const ChosenColumns& chosen = {});

/// Replaces or adds columns of a loop, computed from its columns in SI. @returns the origin of its columns.
/// @throws FormatError for a choice that does not fit.
[[nodiscard]] ChannelNames choose_columns(Table& loop, const std::string& path, const ChosenColumns& chosen);

/// Checks that a table has the columns of a loop with their units. @throws FormatError as read_loop_table.
void require_loop_columns(const Table& table, const std::string& path, LoopColumns wanted = LoopColumns::complete);

/// A table as CSV: header cells "name [unit]", numbers with all their digits, NaN as empty cell.
/// @throws InvalidArgument for columns of different length or names that contain a comma, quote or line break.
[[nodiscard]] std::string as_csv(const Table& table);

/// Writes as_csv(table) as a whole.
/// @throws FileError; InvalidArgument as as_csv.
void write_csv(const std::string& path, const Table& table);

}  // namespace setae::tables
