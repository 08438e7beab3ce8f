// SPDX-License-Identifier: GPL-3.0-or-later
// Files of force curves. A text that begins with a record separator lists the members of an archive, each a name, a
// unit separator and its content: a damaged archive as a whole would stop at its checksums.
#include <cmath>
#include <cstdlib>
#include <string>

#include "fuzz_input.hpp"
#include "sample_files.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/force_map.hpp"

namespace {

using namespace setae;

std::string file_of(std::string_view told) {
    constexpr char record = '\x1e', unit = '\x1f';
    if (told.empty() || told.front() != record) return std::string(told);
    setae::tests::Members members;
    while (!told.empty()) {
        told.remove_prefix(1);
        const auto member = told.substr(0, told.find(record));
        const auto cut = member.find(unit);
        if (cut != 0 && cut != std::string_view::npos)
            members.emplace_back(std::string(member.substr(0, cut)), std::string(member.substr(cut + 1)));
        told.remove_prefix(member.size());
    }
    return members.empty() ? std::string() : setae::tests::zip_archive(members);
}

/// Columns of one length, or refused; anything else ends the program.
void read_curve(const tables::ForceCurves& curves, long number) {
    try {
        const auto curve = curves.read(number);
        for (const auto& column : curve.table.columns)
            if (column.values.size() != curve.table.rows()) std::abort();
        if (curves.grid) (void)curves.grid->pixel(curve.x, curve.y);
    } catch (const Error&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto curves =
            tables::open_force_curves(bytes::memory_source("input", file_of(fuzz::text_of(data, size))));
        if (curves.numbers.empty()) std::abort();
        constexpr std::size_t most = 4;
        for (std::size_t i = 0; i < curves.numbers.size() && i < most; ++i) read_curve(curves, curves.numbers[i]);
    } catch (const Error&) {
    }
    return 0;
}
