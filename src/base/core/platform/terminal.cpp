// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/platform/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

namespace setae::platform {
namespace {

int number_of(Stream stream) { return stream == Stream::output ? STDOUT_FILENO : STDERR_FILENO; }

}  // namespace

bool is_terminal(Stream stream) { return ::isatty(number_of(stream)) != 0; }

std::size_t columns_of(Stream stream) {
    winsize size{};
    return ::ioctl(number_of(stream), TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace setae::platform
