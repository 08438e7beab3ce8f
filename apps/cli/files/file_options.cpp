// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_options.hpp"

namespace setae::cli {
void add_layout_option(Options& options, std::string& as) {
    options
        .add(
            "--as", as,
            "how text of three columns is read: matrix, a narrow map, or columns, points x y z; default: from the numbers; "
            "spectrum: a table of a spectrum whose header does not say so")
        .one_of_unlisted({"matrix", "columns", "spectrum"});
}

void add_keep_values_option(Options& options, bool& keep_values) {
    options.flag("--keep-values", keep_values,
                 "values that mark missing heights (NO_DATA), such as -9999, stay heights; default: undefined");
}

void add_file_options(Options& options, answers::FileRequest& file) {
    options.add("--size", file.size, "extent where the file leaves it open: \"1 mm x 1 mm\" or \"2 mm\"")
        .read_by([](const std::string& text) { (void)answers::lengths_of(text); });
    options.add(
        "--unit", file.unit,
        "unit of lengths where the file leaves it open, such as um; \"mm, um\": of x, then of heights; of a table of a spectrum \"1/um, nm3\", \"frequency 1/um, one-sided nm3\" or \"wavevector, W1\"");
    add_layout_option(options, file.as);
    options.add("--channel", file.channel,
                "channel: its number, counted from 0 as `setae info` lists them, or its name or the beginning of it");
    add_keep_values_option(options, file.keep_values);
}

}  // namespace setae::cli
