// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::parallel {

/// Lets the process keep up to 256 MiB of what it frees for its next arrays, in place of giving it back to the system
/// and asking again.
///
/// Many small computations in a row, such as fits of thousands of loops, otherwise spend a quarter to half of their
/// time on that. Call it once, at the start of a program. glibc alone; nothing elsewhere.
void keep_freed_memory();

}  // namespace setae::parallel
