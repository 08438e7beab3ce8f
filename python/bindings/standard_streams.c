/* SPDX-License-Identifier: GPL-3.0-or-later
 * stderr and stdout for code of this module that was not compiled for a shared library. The option --wrap of the linker replaces
 * them by these variables, whose addresses are known at link time. */
#include <stdio.h>

extern FILE* __real_stderr;
extern FILE* __real_stdout;
__attribute__((visibility("hidden"))) FILE* __wrap_stderr;
__attribute__((visibility("hidden"))) FILE* __wrap_stdout;

__attribute__((constructor(101))) static void take_streams(void) {
    __wrap_stderr = __real_stderr;
    __wrap_stdout = __real_stdout;
}
