// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "program/options.hpp"
#include "setae/formats/channel.hpp"

namespace setae::cli {

/// Registers --as matrix|columns: how text is to be read whose columns have two meanings.
void add_layout_option(Options& options, std::string& as);

/// Options for files that leave something open: --size "1 mm x 1 mm", --unit um, --as columns, --channel K.
struct FileOptions {
    std::string size;
    std::string unit;
    std::string as;
    std::optional<std::size_t> channel;

    void add_to(Options& options);
    /// @throws InvalidArgument for a malformed size.
    [[nodiscard]] formats::ReadOptions read_options() const;
};

}  // namespace setae::cli
