// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace setae::bytes {

/// Does once in a child process what the caller is about to do with a library that damaged bytes may crash, so that
/// they cost one file and not the program.
///
/// What `use` throws, gives back or prints is lost: the caller does it again. Locks that `use` takes must be the
/// caller's own.
/// @throws FormatError "name: `library`: …" where the child is killed by a signal, ends by itself or takes longer than
/// a minute; FileError where no child can be had.
void rehearse(const std::string& name, const std::string& library, const std::function<void()>& use);

/// From here on rehearse() does nothing: for fuzzers of what stands above the library, which look for crashes
/// themselves.
void leave_out_rehearsals();

}  // namespace setae::bytes
