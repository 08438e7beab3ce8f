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

/// How a text table is to be taken; what is left open is found from the text.
struct TableOptions {
    bytes::Encoding encoding = bytes::Encoding::detect;  ///< byte order mark, else UTF-8 where valid, else latin-1
    std::optional<char> separator;                       ///< a tab, ',', ';', or ' ' for runs of blanks
    std::optional<char> decimal_point;                   ///< '.' or ','
    std::optional<std::string> header_end;               ///< the line after which numbers begin, such as "eoh"
    std::optional<std::string> sheet;                    ///< of a workbook; else the first that holds a table

    friend bool operator==(const TableOptions&, const TableOptions&) = default;
};

/// A table as the file spells it: names and units of the header (empty where it states none), numbers unconverted.
struct RawTable {
    struct RawColumn {
        std::string name;
        std::string unit;
        Array1D values;
        std::string
            text;  ///< the first cell that is no number, with its place, where the column holds text; values are NaN
    };
    std::vector<RawColumn> columns;
    std::vector<std::string> header;              ///< lines before the numbers, decoded to UTF-8
    std::map<std::string, std::string> metadata;  ///< of header lines "# key: value"
    char separator = ' ';
    char decimal_point = '.';
};

/// Numbers in columns with a header, as the file spells them.
///
/// Separators are tabs, commas, semicolons or blanks, the decimal sign is a point or a comma; both are found by trying
/// which reading makes the most lines regular. Names stand in the last header line with as many cells as columns, units
/// beside them as "force [mN]", "force (mN)", "force / mN", "force in mN", "force_mN", "force, mN" or "force mN", or in
/// a row of their own. Cells may stand in quotes, with separators in them. An empty cell, "nan", "-" and "bad" are
/// undefined; columns of text are kept as names and marked. Thousands may be grouped ("1,234.5", "1.234,5", "1'234.5",
/// "1 234,5"). Commas that may group thousands as well as begin decimals ("1,234" without any cell that decides) are
/// refused, as are rows with twice as many cells as names at commas. A workbook (.xlsx) is read by read_spreadsheet.
/// @throws FileError; FormatError that names the line where a row has another number of columns.
[[nodiscard]] RawTable read_raw_table(const bytes::Source& source, const TableOptions& options = {});

/// A raw table in SI. A column without unit keeps its numbers and has the empty unit; so does one whose unit setae does
/// not know (such as °C), which then keeps the file's spelling. metadata["header"] holds the header lines, further keys
/// those of lines "# key: value".
[[nodiscard]] Table table_in_si(const RawTable& raw, const std::string& path);
/// The same of a file.
[[nodiscard]] Table read_table(const std::string& path, const TableOptions& options = {});

/// What a loop's table must hold beside the force.
enum class LoopColumns {
    complete,      ///< displacement or contact radius
    force_record,  ///< nothing: the contact radius comes from elsewhere
};

/// Columns of a file chosen for a loop's: {"force", "Load"}, {"force", "2"}, {"force", "Load[mN]"}, where the unit
/// replaces the header's, or expressions such as {"force", "-1 * load"}.
using ChosenColumns = std::map<std::string, std::string>;

/// Where a column of a loop comes from, as a choice would name it.
struct ChannelName {
    std::string column;      ///< of the file, such as "load"; empty where it is computed from several
    std::string unit;        ///< of that column, as it was taken
    std::string expression;  ///< such as "load", "kraft[uN]", "-1 * gap"
};

/// By the names force, displacement, contact_radius and time.
using ChannelNames = std::map<std::string, ChannelName>;

/// A loop's columns, and which of the file's they are.
struct LoopTable {
    Table table;
    ChannelNames channels;
    std::vector<std::string> taken;   ///< a sentence for each column that words told, such as "contact_radius from …"
    std::vector<std::string> unused;  ///< names of the columns that play no part
};

/// A loop: column "force" [N] and "displacement" [m] or "contact_radius" [m], optionally "time" [s], in SI. Names are
/// compared without regard to case; a column of another name is taken where words and units leave it the only one that
/// may be meant, as `setae jkr import` recognises it ("contact radius [um]", "load [mN]"). What is chosen overrules all
/// of this.
/// @throws FormatError that names the missing column or unit and the choice that helps, as for a table without forces.
[[nodiscard]] LoopTable read_loop_table(const std::string& path, LoopColumns wanted = LoopColumns::complete,
                                        const ChosenColumns& chosen = {});

/// Replaces or adds columns of a loop, by those it has, which are in SI; and where its columns come from.
/// @throws FormatError for a choice that does not fit.
[[nodiscard]] ChannelNames choose_columns(Table& loop, const std::string& path, const ChosenColumns& chosen);

/// Checks that a table has a loop's columns in their units. @throws FormatError as read_loop_table.
void require_loop_columns(const Table& table, const std::string& path, LoopColumns wanted = LoopColumns::complete);

/// A table as CSV: header cells "name [unit]", numbers with all their digits, NaN as empty cell.
/// @throws InvalidArgument for columns of different length or names that hold a comma, quote or line break.
[[nodiscard]] std::string as_csv(const Table& table);

/// Writes as_csv(table) as a whole.
/// @throws FileError; InvalidArgument as as_csv.
void write_csv(const std::string& path, const Table& table);

}  // namespace setae::tables
