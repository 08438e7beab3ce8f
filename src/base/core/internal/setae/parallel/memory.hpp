// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::parallel {

/// Lets the process keep up to 1.5 GiB of what it frees for its next arrays, in place of giving it back to the system
/// and asking again; the first GiB is filled by large pages where the system has them.
///
/// Many small computations in a row, such as fits of thousands of loops, otherwise spend a quarter to half of their
/// time on that, and those on large maps a fifth. Call it once, at the start of a program. glibc alone; nothing
/// elsewhere.
void keep_freed_memory();

}  // namespace setae::parallel
