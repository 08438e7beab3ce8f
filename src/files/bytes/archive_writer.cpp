// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/archive_writer.hpp"

#include <zip.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "setae/bytes/archive.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

constexpr zip_uint16_t first_day = (1 << 5) | 1;  // 1980-01-01, the beginning of time in ZIP archives

/// Source of a member for libzip. No exception may pass through libzip: it is stored and thrown afterwards.
struct MemberReader {
    const ArchiveMember* member = nullptr;
    std::exception_ptr* failure = nullptr;
    std::optional<Source> source;
    std::uint64_t at = 0;
    zip_error_t error{};

    const Source& opened() {
        if (!source) source = member->content();
        return *source;
    }
    zip_int64_t read(char* target, zip_uint64_t length) {
        const auto count = std::min<std::uint64_t>(length, opened().size - at);
        if (count > 0) opened().read_into(at, count, target);
        at += count;
        return static_cast<zip_int64_t>(count);
    }
    zip_int64_t describe(void* target) {
        auto* stat = static_cast<zip_stat_t*>(target);
        zip_stat_init(stat);
        stat->valid = ZIP_STAT_SIZE;
        stat->size = opened().size;
        return sizeof(zip_stat_t);
    }
    zip_int64_t answer(void* data, zip_uint64_t length, zip_source_cmd_t command) {
        switch (command) {
            case ZIP_SOURCE_OPEN: at = 0; return 0;
            case ZIP_SOURCE_READ: return read(static_cast<char*>(data), length);
            case ZIP_SOURCE_CLOSE: source.reset(); return 0;
            case ZIP_SOURCE_STAT: return describe(data);
            case ZIP_SOURCE_ERROR: return zip_error_to_data(&error, data, length);
            case ZIP_SOURCE_FREE: return 0;
            case ZIP_SOURCE_SUPPORTS:
                return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE,
                                                      ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, -1);
            default: zip_error_set(&error, ZIP_ER_OPNOTSUPP, 0); return -1;
        }
    }

    static zip_int64_t callback(void* self, void* data, zip_uint64_t length, zip_source_cmd_t command) {
        auto& reader = *static_cast<MemberReader*>(self);
        try {
            return reader.answer(data, length, command);
        } catch (...) {
            if (!*reader.failure) *reader.failure = std::current_exception();
            zip_error_set(&reader.error, ZIP_ER_READ, 0);
            return -1;
        }
    }
};

struct Discard {
    void operator()(zip* archive) const { zip_discard(archive); }
};
using OpenArchive = std::unique_ptr<zip, Discard>;

OpenArchive created(const std::string& path) {
    int code = 0;
    OpenArchive archive(zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
    if (!archive)
        throw FileError(fmt::format("{}: cannot be created; check that the folder exists and is writable", path));
    return archive;
}

void add(zip* archive, MemberReader& reader, const std::string& path) {
    auto* source = zip_source_function(archive, MemberReader::callback, &reader);
    const auto index = source ? zip_file_add(archive, reader.member->name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (index < 0) {
        if (source) zip_source_free(source);
        throw FileError(
            fmt::format("{}: member '{}' cannot be added: {}", path, reader.member->name, zip_strerror(archive)));
    }
    const auto added = static_cast<zip_uint64_t>(index);
    const bool set = zip_set_file_compression(archive, added, ZIP_CM_STORE, 0) == 0 &&
                     zip_file_set_dostime(archive, added, 0, first_day, 0) == 0;
    if (!set)
        throw FileError(
            fmt::format("{}: member '{}' cannot be stored: {}", path, reader.member->name, zip_strerror(archive)));
}

void check_names(const std::string& path, const std::vector<ArchiveMember>& members) {
    std::set<std::string> names;
    for (const auto& member : members) {
        if (member.name.empty() || !stays_inside(member.name))
            throw InvalidArgument(fmt::format(
                "{}: '{}' is not a valid name of a member; expected a path inside the archive", path, member.name));
        if (!names.insert(member.name).second)
            throw InvalidArgument(fmt::format("{}: two members named '{}'", path, member.name));
    }
}

}  // namespace

namespace {

void fill_archive(const std::string& temporary, const std::string& path, const std::vector<ArchiveMember>& members) {
    std::exception_ptr failure;
    std::vector<MemberReader> readers(members.size());
    auto archive = created(temporary);
    for (std::size_t i = 0; i < members.size(); ++i) {
        readers[i].member = &members[i];
        readers[i].failure = &failure;
        add(archive.get(), readers[i], path);
    }
    if (zip_close(archive.get()) == 0) {
        (void)archive.release();
        return;
    }
    if (failure) std::rethrow_exception(failure);
    throw FileError(fmt::format("{}: cannot be written: {}; check that the folder is writable and has space", path,
                                zip_strerror(archive.get())));
}

}  // namespace

void write_archive(const std::string& path, const std::vector<ArchiveMember>& members) {
    check_names(path, members);
    write_whole_file(path, [&](const std::string& temporary) { fill_archive(temporary, path, members); });
}

}  // namespace setae::bytes
