// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::bytes {

/// While one of these objects exists, no output replaces a file that was read: write_whole_file() refuses every path
/// that leads, by links of any kind, to an input. The last one that ends clears the list.
///
/// A program has one during its run. Threads share the protected inputs.
class ProtectedInputs {
public:
    ProtectedInputs();
    ProtectedInputs(const ProtectedInputs&) = delete;
    ProtectedInputs& operator=(const ProtectedInputs&) = delete;
    ~ProtectedInputs();
};

/// Registers a regular file as input of the run; every file_source() and read_file() does so. No effect for other
/// paths, and without a ProtectedInputs.
void protect_input(const std::string& path);

/// @throws FileError if `path` is a protected input.
void require_no_input(const std::string& path);

}  // namespace setae::bytes
