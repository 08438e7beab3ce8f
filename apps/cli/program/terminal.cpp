// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace setae::cli {
namespace {

/// Columns of a terminal; 0 where the stream is none.
std::size_t columns_of(int stream) {
    winsize size{};
    return ioctl(stream, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace

output::Screen output_size() {
    output::Screen size;
    if (const auto columns = columns_of(STDOUT_FILENO); columns > 0)
        size.width = std::clamp<std::size_t>(columns, 60, 120);
    return size;
}

std::size_t columns_of_errors() {
    const auto columns = columns_of(STDERR_FILENO);
    return columns > 0 ? columns : 80;
}

}  // namespace setae::cli
