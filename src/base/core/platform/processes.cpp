// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/platform/processes.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <thread>
#include <vector>

namespace setae::platform {
namespace {

std::error_code error_of(int number) { return {number, std::generic_category()}; }

/// Waits for a child; false if it was lost.
bool wait_for(pid_t child, int& status) {
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return false;
    return true;
}

ProcessEnd end_of(int status) {
    if (WIFEXITED(status)) return {.start = {}, .exit_code = WEXITSTATUS(status)};
    const int number = WTERMSIG(status);
    return {.start = {},
            .signal = "signal " + std::to_string(number) + ", " + ::strsignal(number),
            .out_of_time = number == SIGALRM || number == SIGXCPU};
}

/// Pointers in the form that the system expects, with a null at the end.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (auto& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Ends the child: signals kill it silently, regardless of the program's handlers.
[[noreturn]] void perform(const std::function<void()>& use, unsigned max_seconds) {
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGXCPU}) ::signal(number, SIG_DFL);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    const rlimit none{0, 0}, seconds{max_seconds, max_seconds};
    ::setrlimit(RLIMIT_CORE, &none);
    ::setrlimit(RLIMIT_CPU, &seconds);
    ::alarm(max_seconds);
    try {
        use();
    } catch (...) {  // the caller meets the same error and reports it
    }
    ::_exit(0);
}

}  // namespace

ProcessId this_process() { return ::getpid(); }

bool is_gone(ProcessId process) { return ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH; }

std::vector<std::string> environment() {
    std::vector<std::string> variables;
    for (char** variable = ::environ; *variable; ++variable) variables.emplace_back(*variable);
    return variables;
}

ProcessEnd run(const Command& command) {
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, command.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                       0600);
    ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    ::posix_spawn_file_actions_addchdir_np(&actions, command.folder.c_str());
    auto words = command.words, variables = command.environment;
    pid_t process = 0;
    const int failure = ::posix_spawnp(&process, words.front().c_str(), &actions, nullptr, pointers_to(words).data(),
                                       pointers_to(variables).data());
    ::posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) return {.start = error_of(failure)};
    int status = 0;
    (void)wait_for(process, status);
    return end_of(status);
}

std::optional<std::string> output_of(const std::string& line) {
    auto* answer = ::popen(line.c_str(), "r");
    if (!answer) return std::nullopt;
    std::string text;
    for (int c = std::fgetc(answer); c != EOF; c = std::fgetc(answer)) text += static_cast<char>(c);
    return ::pclose(answer) == 0 ? std::optional(text) : std::nullopt;
}

std::optional<ProcessEnd> run_in_child(const std::function<void()>& use, unsigned max_seconds) {
    const pid_t child = ::fork();
    if (child < 0) return ProcessEnd{.start = error_of(errno)};
    if (child == 0) perform(use, max_seconds);
    int status = 0;
    if (!wait_for(child, status)) return std::nullopt;
    return end_of(status);
}

void in_every_child(void (*function)()) { ::pthread_atfork(nullptr, nullptr, function); }

namespace {

struct MutexesAtFork {
    std::mutex guard;
    std::vector<std::mutex*> all;
};

MutexesAtFork& at_fork() {
    static auto* mutexes = new MutexesAtFork;
    return *mutexes;
}

/// Locks all or none: no thread waits for a mutex that this thread holds, whatever their order.
bool lock_all(const std::vector<std::mutex*>& mutexes) {
    const auto taken = std::find_if(mutexes.begin(), mutexes.end(), [](auto* mutex) { return !mutex->try_lock(); });
    if (taken == mutexes.end()) return true;
    std::for_each(mutexes.begin(), taken, [](auto* mutex) { mutex->unlock(); });
    return false;
}

void before_fork() {
    for (at_fork().guard.lock(); !lock_all(at_fork().all); at_fork().guard.lock()) {
        at_fork().guard.unlock();
        std::this_thread::yield();
    }
}

void after_fork() {
    for (auto* mutex : at_fork().all) mutex->unlock();
    at_fork().guard.unlock();
}

}  // namespace

std::mutex& free_in_every_child(std::mutex& mutex) {
    auto& mutexes = at_fork();
    static const int registered = ::pthread_atfork(before_fork, after_fork, after_fork);
    (void)registered;
    const std::lock_guard lock(mutexes.guard);
    mutexes.all.push_back(&mutex);
    return mutex;
}

void survive_full_files() { ::signal(SIGXFSZ, SIG_IGN); }

}  // namespace setae::platform
