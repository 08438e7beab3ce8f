// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::bytes {

/// While one of these lives, no output replaces a file that was read: write_whole_file() refuses every path that leads,
/// by links of any kind, to an input. The last one that ends forgets them all.
///
/// A program holds one for its run. Threads share what is protected.
class ProtectedInputs {
public:
    ProtectedInputs();
    ProtectedInputs(const ProtectedInputs&) = delete;
    ProtectedInputs& operator=(const ProtectedInputs&) = delete;
    ~ProtectedInputs();
};

/// A regular file that the run is going to read; every file_source() and read_file() is one by itself. Nothing for
/// other paths, and while no ProtectedInputs lives.
void protect_input(const std::string& path);

/// @throws FileError where `path` is a protected input.
void require_no_input(const std::string& path);

}  // namespace setae::bytes
