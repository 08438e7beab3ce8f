// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/expand.hpp"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

constexpr std::size_t piece = 1 << 17;

[[noreturn]] void broken(const Source& source, std::uint64_t offset, const std::string& format,
                         const std::string& what) {
    throw FormatError(source.name, {.offset = offset}, fmt::format("{}: {}", format, what));
}

void require_bounded(std::size_t expanded, std::size_t compressed, std::uint64_t most, const Source& source,
                     std::uint64_t offset, const std::string& format) {
    if (expanded > most)
        broken(source, offset, format,
               fmt::format("{} compressed bytes expand to more than {}; if you trust the file, expand it with another "
                           "program first",
                           compressed, most));
}

/// zlib's stream that frees itself.
struct Inflation {
    z_stream stream{};
    explicit Inflation(int window) : good(inflateInit2(&stream, window) == Z_OK) {}
    Inflation(const Inflation&) = delete;
    Inflation& operator=(const Inflation&) = delete;
    ~Inflation() { inflateEnd(&stream); }
    bool good;
};

}  // namespace

bool is_gzip(std::string_view head) { return head.starts_with("\x1f\x8b\x08"); }

namespace {

/// The content of a stream that expands to at most `most` bytes, or its beginning once `enough` are available.
std::string inflated_within(std::uint64_t most, std::string_view stream, const Source& source, std::uint64_t offset,
                            const std::string& format, std::uint64_t enough) {
    constexpr int zlib_or_gzip = 15 + 32;
    Inflation inflation(zlib_or_gzip);
    if (!inflation.good) throw InternalError("zlib cannot be started");
    auto& z = inflation.stream;
    std::string content;
    for (std::size_t used = 0;;) {
        const auto input = std::min<std::size_t>(stream.size() - used, 1u << 30);
        z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(stream.data() + used));
        z.avail_in = static_cast<uInt>(input);
        const auto before = content.size();
        content.resize(before + piece);
        z.next_out = reinterpret_cast<Bytef*>(content.data() + before);
        z.avail_out = piece;
        const int state = inflate(&z, Z_NO_FLUSH);
        used += input - z.avail_in;
        content.resize(before + piece - z.avail_out);
        require_bounded(content.size(), stream.size(), most, source, offset, format);
        if (state == Z_STREAM_END || content.size() >= enough) return content;
        if (state != Z_OK && state != Z_BUF_ERROR) broken(source, offset + used, format, "compressed data are damaged");
        if (used == stream.size() && content.size() == before)
            broken(source, offset + used, format, "compressed data end early; the file is truncated");
    }
}

}  // namespace

std::string inflated(std::string_view stream, const Source& source, std::uint64_t offset, const std::string& format,
                     std::uint64_t enough) {
    return inflated_within(max_expanded(stream.size()), stream, source, offset, format, enough);
}

namespace {

/// At most 8 MiB of memory for any stream.
std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> zstd_context() {
    std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(), &ZSTD_freeDCtx);
    ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, 23);
    return context;
}

}  // namespace

std::string expanded_zstd(std::string_view stream, const Source& source, std::uint64_t offset,
                          const std::string& format) {
    const auto context = zstd_context();
    std::string content;
    ZSTD_inBuffer input{stream.data(), stream.size(), 0};
    for (;;) {
        const auto before = content.size();
        content.resize(before + piece);
        ZSTD_outBuffer output{content.data() + before, piece, 0};
        const auto state = ZSTD_decompressStream(context.get(), &output, &input);
        content.resize(before + output.pos);
        if (ZSTD_isError(state))
            broken(source, offset + input.pos, format,
                   fmt::format("compressed data are damaged: {}", ZSTD_getErrorName(state)));
        require_bounded(content.size(), stream.size(), max_expanded(stream.size()), source, offset, format);
        if (state == 0) return content;
        if (input.pos == input.size && output.pos == 0)
            broken(source, offset + input.pos, format, "compressed data end early; the file is truncated");
    }
}

Source unpacked(const Source& source) {
    if (!is_gzip(source.head(3))) return source;
    const auto packed = source.all();
    return memory_source(source.name, inflated_within(max_expanded_text(packed.size()), packed, source, 0, "gzip",
                                                      std::numeric_limits<std::uint64_t>::max()));
}

std::string expanded_zstd_head(std::string_view stream, std::uint64_t count, const Source& source, std::uint64_t offset,
                               const std::string& format) {
    const auto context = zstd_context();
    std::string content(std::min<std::uint64_t>(count, max_expanded(stream.size())), '\0');
    ZSTD_inBuffer input{stream.data(), stream.size(), 0};
    ZSTD_outBuffer output{content.data(), content.size(), 0};
    for (auto state = std::size_t{1}; state != 0 && output.pos < output.size;) {
        const auto before = input.pos + output.pos;
        state = ZSTD_decompressStream(context.get(), &output, &input);
        if (ZSTD_isError(state))
            broken(source, offset + input.pos, format,
                   fmt::format("compressed data are damaged: {}", ZSTD_getErrorName(state)));
        if (input.pos + output.pos == before) break;
    }
    content.resize(output.pos);
    return content;
}

}  // namespace setae::bytes
