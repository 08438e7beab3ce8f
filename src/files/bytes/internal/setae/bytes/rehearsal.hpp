// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace setae::bytes {

/// Executes `use` first in a child process, for libraries that may crash on damaged bytes: damage then affects one file
/// and not the program.
///
/// Exceptions, results and output of `use` are lost: the caller repeats the work. Locks taken by `use` must belong to
/// the caller.
/// @throws FormatError "name: `library`: …" if a signal ends the child, it exits or takes longer than a minute;
/// FileError if no child can be started.
void rehearse(const std::string& name, const std::string& library, const std::function<void()>& use);

/// Disables rehearse(): for fuzzers of code that uses the library, which detect crashes themselves.
void disable_rehearsals();

}  // namespace setae::bytes
