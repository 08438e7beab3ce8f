// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "program/options.hpp"
#include "setae/answers/surface_request.hpp"

namespace setae::cli {

/// Registers --as matrix|columns: how text is to be read whose columns have two meanings.
void add_layout_option(Options& options, std::string& as);

/// Registers --keep-values: what marks missing heights stays a height.
void add_keep_values_option(Options& options, bool& keep_values);

/// Options for files that leave something open: --size "1 mm x 1 mm", --unit um, --as columns, --channel K,
/// --keep-values.
void add_file_options(Options& options, answers::FileRequest& file);

struct FileOptions : answers::FileRequest {
    void add_to(Options& options) { add_file_options(options, *this); }
};

}  // namespace setae::cli
