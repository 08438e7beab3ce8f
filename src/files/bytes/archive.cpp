// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/archive.hpp"

#include <zip.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/expand.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

struct CloseMember {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

constexpr std::uint64_t head_bytes = 1 << 16;
constexpr std::uint64_t largest_head = 1 << 20;  ///< of a member that is expanded in part

[[noreturn]] void broken(const Source& source, const std::string& what) {
    throw FormatError(source.name, {}, "ZIP: " + what);
}

/// Throws: the directory at the end of an archive is missing.
[[noreturn]] void no_archive(const Source& source, const std::string& reason) {
    throw FormatError(source.name, {.offset = source.size},
                      fmt::format("ZIP: {}; the archive is damaged or truncated", reason));
}

/// Source of an archive for libzip: any source, from the place given by its directory.
struct Reading {
    Source source;
    std::uint64_t position = 0;
    zip_error_t error{};
};

zip_int64_t served(void* state, void* data, zip_uint64_t length, zip_source_cmd_t command) {
    auto& reading = *static_cast<Reading*>(state);
    const auto size = reading.source.size;
    switch (command) {
        case ZIP_SOURCE_OPEN: reading.position = 0; return 0;
        case ZIP_SOURCE_READ:
            try {
                const auto count = std::min(length, size - reading.position);
                reading.source.read_into(reading.position, count, static_cast<char*>(data));
                reading.position += count;
                return static_cast<zip_int64_t>(count);
            } catch (const std::exception&) {
                zip_error_set(&reading.error, ZIP_ER_READ, 0);
                return -1;
            }
        case ZIP_SOURCE_SEEK: {
            const auto place = zip_source_seek_compute_offset(reading.position, size, data, length, &reading.error);
            if (place < 0) return -1;
            reading.position = static_cast<std::uint64_t>(place);
            return 0;
        }
        case ZIP_SOURCE_TELL: return static_cast<zip_int64_t>(reading.position);
        case ZIP_SOURCE_STAT: {
            auto* stat = static_cast<zip_stat_t*>(data);
            zip_stat_init(stat);
            stat->size = size;
            stat->valid |= ZIP_STAT_SIZE;
            return sizeof(zip_stat_t);
        }
        case ZIP_SOURCE_CLOSE: return 0;
        case ZIP_SOURCE_ERROR: return zip_error_to_data(&reading.error, data, length);
        case ZIP_SOURCE_FREE:
            zip_error_fini(&reading.error);
            delete &reading;
            return 0;
        case ZIP_SOURCE_SUPPORTS:
            return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT,
                                                  ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL,
                                                  ZIP_SOURCE_SUPPORTS, -1);
        default: zip_error_set(&reading.error, ZIP_ER_OPNOTSUPP, 0); return -1;
    }
}

zip* opened(const Source& source) {
    auto reading = std::make_unique<Reading>(Reading{source});
    zip_error_init(&reading->error);
    zip_error_t error;
    zip_error_init(&error);
    auto* through = zip_source_function_create(served, reading.get(), &error);
    if (through) reading.release();  // freed with the source
    auto* archive = through ? zip_open_from_source(through, ZIP_RDONLY, &error) : nullptr;
    const std::string reason = archive ? "" : zip_error_strerror(&error);
    zip_error_fini(&error);
    if (archive) return archive;
    if (through) zip_source_free(through);
    no_archive(source, reason);
}

/// Properties of a member in the directory.
zip_stat_t announced(zip* archive, std::uint64_t index, const Source& source) {
    zip_stat_t stat;
    if (zip_stat_index(archive, index, 0, &stat) != 0 || !(stat.valid & ZIP_STAT_SIZE) ||
        !(stat.valid & ZIP_STAT_COMP_SIZE))
        broken(source, fmt::format("member {} has no size", index));
    return stat;
}

/// A member expanded on request: only its beginning while that is small, then completely and once, from any thread.
struct Close {
    void operator()(zip* archive) const { zip_discard(archive); }
};

}  // namespace

/// Shared state of the copies of an archive and its members. libzip is used by one thread at a time.
class Archive::Opened {
public:
    explicit Opened(const Source& source) : source_(source), zip_(opened(source_)) {
        std::set<std::string> known;
        for (auto& name : names()) {
            if (!stays_inside(name))
                broken(source_,
                       fmt::format(
                           "member '{:.80}' would be written outside the folder of the archive, so that it is refused",
                           name));
            if (!known.insert(name).second)
                broken(
                    source_,
                    fmt::format(
                        "two members are named '{:.80}', and programs differ in which one they read; remove one of them",
                        name));
        }
    }

    [[nodiscard]] const Source& source() const { return source_; }

    [[nodiscard]] std::vector<std::string> names() const {
        const std::lock_guard lock(guard_);
        return locked_names();
    }

    [[nodiscard]] bool has(const std::string& name) const {
        const std::lock_guard lock(guard_);
        return zip_name_locate(zip_.get(), name.c_str(), 0) >= 0;
    }

    [[nodiscard]] zip_stat_t stat(const std::string& name) const {
        const std::lock_guard lock(guard_);
        return announced(zip_.get(), index_of(name), source_);
    }

    [[nodiscard]] std::string head(const std::string& name, std::uint64_t count) const;

private:
    [[nodiscard]] std::vector<std::string> locked_names() const {
        std::vector<std::string> names;
        const auto count = zip_get_num_entries(zip_.get(), 0);
        for (zip_int64_t i = 0; i < count; ++i)
            if (const char* name = zip_get_name(zip_.get(), static_cast<zip_uint64_t>(i), 0)) names.emplace_back(name);
        return names;
    }

    [[nodiscard]] std::uint64_t index_of(const std::string& name) const {
        const auto index = zip_name_locate(zip_.get(), name.c_str(), 0);
        if (index < 0)
            broken(source_,
                   fmt::format("no member '{}'; the archive contains: {}", name, fmt::join(locked_names(), ", ")));
        return static_cast<std::uint64_t>(index);
    }

    Source source_;
    mutable std::mutex guard_;
    std::unique_ptr<zip, Close> zip_;
};

namespace {

/// A member that is expanded on reading. A large one is read by a separate archive, so threads read several
/// simultaneously; for small ones reading the directory again would take longer.
struct LazyMember {
    Archive archive;
    Source source;  ///< of the archive
    std::string name;
    std::mutex guard;
    std::shared_ptr<const std::string> head, content;

    LazyMember(Archive of, Source from, std::string named)
        : archive(std::move(of)), source(std::move(from)), name(std::move(named)) {}

    std::shared_ptr<const std::string> holding(std::uint64_t end) {
        const std::lock_guard lock(guard);
        if (content) return content;
        if (end > head->size() && end <= largest_head)
            head = std::make_shared<const std::string>(archive.head(name, std::max(2 * end, 4 * head_bytes)));
        if (end > largest_head) content = std::make_shared<const std::string>(Archive(source).read(name));
        return content ? content : head;
    }
};

}  // namespace

bool stays_inside(std::string_view name) {
    if (name.starts_with('/') || name.starts_with('\\') || (name.size() > 1 && name[1] == ':')) return false;
    while (!name.empty()) {
        const auto end = std::min(name.find_first_of("/\\"), name.size());
        if (name.substr(0, end) == "..") return false;
        name.remove_prefix(std::min(end + 1, name.size()));
    }
    return true;
}

bool is_zip(std::string_view head) { return head.starts_with("PK\x03\x04"); }

Archive::Archive(const Source& source) : opened_(std::make_shared<Opened>(source)) {}

std::vector<std::string> Archive::names() const { return opened_->names(); }

bool Archive::has(const std::string& name) const { return opened_->has(name); }

std::uint64_t Archive::size(const std::string& name) const { return opened_->stat(name).size; }

std::string Archive::read(const std::string& name) const {
    return head(name, std::numeric_limits<std::uint64_t>::max());
}

std::string Archive::head(const std::string& name, std::uint64_t count) const { return opened_->head(name, count); }

std::string Archive::Opened::head(const std::string& name, std::uint64_t count) const {
    const std::lock_guard lock(guard_);
    const auto index = index_of(name);
    const auto compressed = std::min<std::uint64_t>(announced(zip_.get(), index, source_).comp_size, source_.size);
    const std::unique_ptr<zip_file_t, CloseMember> file(zip_fopen_index(zip_.get(), index, 0));
    if (!file) broken(source_, fmt::format("member '{}': {}", name, zip_strerror(zip_.get())));
    std::string content;
    const auto expected = std::min({announced(zip_.get(), index, source_).size, max_expanded(compressed), count});
    content.reserve(expected);
    // a map has tens of thousands of small members, which do not need the chunk of a large one
    std::vector<char> chunk(std::clamp<std::uint64_t>(expected, 1 << 12, 1 << 18));
    while (content.size() < count) {
        const auto got =
            zip_fread(file.get(), chunk.data(), std::min<std::uint64_t>(chunk.size(), count - content.size()));
        if (got < 0) broken(source_, fmt::format("member '{}' is damaged: {}", name, zip_file_strerror(file.get())));
        if (got == 0) break;
        content.append(chunk.data(), static_cast<std::size_t>(got));
        if (content.size() > max_expanded(compressed))
            broken(source_,
                   fmt::format(
                       "member '{}' expands from {} bytes to more than {}; if you trust the archive, unpack it with "
                       "another program first",
                       name, compressed, max_expanded(compressed)));
    }
    return content;
}

Source Archive::member(const std::string& name) const {
    const auto& archive = opened_->source();
    const auto stat = opened_->stat(name);
    if (const auto compressed = std::min<std::uint64_t>(stat.comp_size, archive.size);
        stat.size > max_expanded(compressed))
        broken(archive,
               fmt::format("member '{}' announces {} bytes, but {} compressed bytes cannot expand to more than {}; the "
                           "archive is damaged",
                           name, stat.size, compressed, max_expanded(compressed)));
    auto lazy = std::make_shared<LazyMember>(*this, archive, name);
    lazy->head = std::make_shared<const std::string>(head(name, head_bytes));
    Source source{fmt::format("{}: {}", archive.name, name), stat.size, {}, {}};
    source.read_into = [lazy, label = source.name, size = source.size](std::uint64_t offset, std::uint64_t count,
                                                                       char* target) {
        if (offset > size || count > size - offset)
            throw FormatError(
                label, {.offset = size},
                fmt::format("the member ends here, expected {} bytes from byte {}; it is truncated", count, offset));
        const auto held = lazy->holding(offset + count);
        if (offset + count > held->size())
            throw FormatError(label, {.offset = held->size()},
                              "ZIP: the member is shorter than the directory of the archive states");
        std::copy_n(held->data() + offset, count, target);
    };
    return source;
}

}  // namespace setae::bytes
