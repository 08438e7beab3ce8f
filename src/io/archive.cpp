// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive.hpp"

#include <zip.h>

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"

namespace setae::io {
namespace {

struct CloseMember {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

[[noreturn]] void broken(const Source& source, const std::string& what) {
    throw FormatError(source.name, {}, "ZIP: " + what);
}

zip* opened_file(const Source& source) {
    int code = 0;
    auto* archive = zip_open(source.path.c_str(), ZIP_RDONLY, &code);
    if (archive) return archive;
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    broken(source, reason + "; the archive is damaged or truncated");
}

zip* opened_memory(const Source& source, const std::string& content) {
    zip_error_t error;
    zip_error_init(&error);
    auto* buffer = zip_source_buffer_create(content.data(), content.size(), 0, &error);
    auto* archive = buffer ? zip_open_from_source(buffer, ZIP_RDONLY, &error) : nullptr;
    const std::string reason = archive ? "" : zip_error_strerror(&error);
    zip_error_fini(&error);
    if (archive) return archive;
    if (buffer) zip_source_free(buffer);
    broken(source, reason + "; the archive is damaged or truncated");
}

}  // namespace

bool is_zip(std::string_view head) { return head.starts_with("PK\x03\x04"); }

void Archive::Close::operator()(zip* archive) const { zip_discard(archive); }

Archive::Archive(const Source& source) : source_(source) {
    if (source.path.empty()) content_ = std::make_shared<const std::string>(source.all());
    zip_.reset(content_ ? opened_memory(source_, *content_) : opened_file(source_));
}

std::vector<std::string> Archive::names() const {
    std::vector<std::string> names;
    const auto count = zip_get_num_entries(zip_.get(), 0);
    for (zip_int64_t i = 0; i < count; ++i)
        if (const char* name = zip_get_name(zip_.get(), static_cast<zip_uint64_t>(i), 0)) names.emplace_back(name);
    return names;
}

bool Archive::has(const std::string& name) const { return zip_name_locate(zip_.get(), name.c_str(), 0) >= 0; }

std::string Archive::read(const std::string& name) const {
    const auto index = zip_name_locate(zip_.get(), name.c_str(), 0);
    if (index < 0) broken(source_, fmt::format("no member '{}', it holds: {}", name, fmt::join(names(), ", ")));
    const std::unique_ptr<zip_file_t, CloseMember> file(zip_fopen_index(zip_.get(), static_cast<zip_uint64_t>(index), 0));
    if (!file) broken(source_, fmt::format("member '{}': {}", name, zip_strerror(zip_.get())));
    std::string content;
    std::vector<char> chunk(1 << 18);
    for (;;) {
        const auto got = zip_fread(file.get(), chunk.data(), chunk.size());
        if (got < 0) broken(source_, fmt::format("member '{}' is damaged: {}", name, zip_file_strerror(file.get())));
        if (got == 0) return content;
        content.append(chunk.data(), static_cast<std::size_t>(got));
    }
}

Source Archive::member(const std::string& name) const {
    return memory_source(fmt::format("{}: {}", source_.name, name), read(name));
}

}  // namespace setae::io
