// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/rehearsal.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

std::atomic<bool> left_out = false;

constexpr unsigned most_seconds = 60;

/// Ends the child: signals kill it without a word, whatever the program does with them.
[[noreturn]] void perform(const std::function<void()>& use) {
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGXCPU}) ::signal(number, SIG_DFL);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    const rlimit none{0, 0}, seconds{most_seconds, most_seconds};
    ::setrlimit(RLIMIT_CORE, &none);
    ::setrlimit(RLIMIT_CPU, &seconds);
    ::alarm(most_seconds);
    try {
        use();
    } catch (...) {  // the caller meets it, too, and knows what to say
    }
    ::_exit(0);
}

/// Why a child that did not end well ended, in words.
std::string end_of_child(int status) {
    if (WIFEXITED(status))
        return fmt::format("the library ends the program that reads it (exit code {})", WEXITSTATUS(status));
    const int number = WTERMSIG(status);
    return number == SIGALRM || number == SIGXCPU
               ? fmt::format("the library does not end within {} s", most_seconds)
               : fmt::format("the library fails on it (signal {}, {})", number, ::strsignal(number));
}

}  // namespace

void rehearse(const std::string& name, const std::string& library, const std::function<void()>& use) {
    if (left_out) return;
    const pid_t child = ::fork();
    if (child < 0)
        throw FileError(fmt::format("{}: no process can be had to read it in ({})", name, std::strerror(errno)));
    if (child == 0) perform(use);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw FileError(fmt::format("{}: lost the process that reads it", name));
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    throw FormatError(name, {}, fmt::format("{}: {}; the file is damaged", library, end_of_child(status)));
}

void leave_out_rehearsals() { left_out = true; }

}  // namespace setae::bytes
