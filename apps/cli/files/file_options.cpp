// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_options.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::cli {
namespace {

/// "1 mm x 1 mm" or "2 mm".
std::vector<double> lengths_of(const std::string& text) {
    std::vector<double> lengths;
    std::string rest = text;
    for (std::size_t at = rest.find(" x "); at != std::string::npos; at = rest.find(" x ")) {
        lengths.push_back(parse_quantity(rest.substr(0, at), dimension::length));
        rest = rest.substr(at + 3);
    }
    lengths.push_back(parse_quantity(rest, dimension::length));
    if (lengths.size() > 2)
        throw InvalidArgument(
            fmt::format("'{}' has {} lengths; expected \"1 mm x 1 mm\" or \"2 mm\"", text, lengths.size()));
    return lengths;
}

}  // namespace

void add_layout_option(Options& options, std::string& as) {
    options
        .add(
            "--as", as,
            "how text of three columns is read: matrix, a narrow map, or columns, points x y z; default: from the numbers; "
            "spectrum: a table of a spectrum whose header does not say so")
        .one_of_unlisted({"matrix", "columns", "spectrum"});
}

void FileOptions::add_to(Options& options) {
    options.add("--size", size, "extent where the file leaves it open: \"1 mm x 1 mm\" or \"2 mm\"")
        .read_by([](const std::string& text) { (void)lengths_of(text); });
    options.add(
        "--unit", unit,
        "unit of lengths where the file leaves it open, such as um; \"mm, um\": of x, then of heights; of a table of a spectrum \"1/um, nm3\" or \"frequency 1/um, nm3\"");
    add_layout_option(options, as);
    options.add("--channel", channel, "channel, counted from 0 as `setae info` lists them").between(0, 1000000);
}

formats::ReadOptions FileOptions::read_options() const {
    formats::ReadOptions options;
    if (!unit.empty()) options.unit = unit;
    if (as == "spectrum")
        throw InvalidArgument(
            "--as spectrum: a table of a spectrum holds no heights; setae psd, params, adhesion and "
            "synthesize take it");
    if (!as.empty()) options.layout = as == "matrix" ? formats::TextLayout::matrix : formats::TextLayout::columns;
    if (!size.empty()) options.size = lengths_of(size);
    return options;
}

}  // namespace setae::cli
