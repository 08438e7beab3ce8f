// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded before the C library (LD_PRELOAD): writes every fsync and rename of a program into $RECORDED_CALLS, a line
// each, "fsync DEVICE:INODE" and "rename DEVICE:INODE PATH". $UNFLUSHED=1 flushes nothing, which shows what flushing
// costs.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace {

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

void record(const char* call, const struct stat& of, const char* path) {
    const char* log = std::getenv("RECORDED_CALLS");
    if (!log) return;
    char line[5000];
    const int length = std::snprintf(line, sizeof line, "%s %lu:%lu %s\n", call, static_cast<unsigned long>(of.st_dev),
                                     static_cast<unsigned long>(of.st_ino), path);
    const int file = open(log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (file < 0) return;
    if (write(file, line, static_cast<std::size_t>(length)) != length) std::abort();
    close(file);
}

}  // namespace

extern "C" int fsync(int file) {
    struct stat of {};
    if (fstat(file, &of) == 0) record("fsync", of, "");
    return std::getenv("UNFLUSHED") ? 0 : next<int(int)>("fsync")(file);
}

extern "C" int rename(const char* from, const char* to) {
    struct stat of {};
    if (lstat(from, &of) == 0) record("rename", of, to);
    return next<int(const char*, const char*)>("rename")(from, to);
}
