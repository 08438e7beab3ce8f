// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/pieces.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

/// A piece and its offset in the whole.
struct Part {
    std::uint64_t at = 0;
    Piece piece;
};

}  // namespace

Source joined(const Source& source, std::string name, const std::vector<Piece>& pieces) {
    std::vector<Part> parts;
    std::uint64_t total = 0;
    for (const auto& piece : pieces) {
        if (piece.offset > source.size || piece.size > source.size - piece.offset)
            throw FormatError(source.name, {.offset = source.size},
                              fmt::format("the file ends here, but '{}' extends to byte {}; it is truncated or damaged",
                                          name, piece.offset + piece.size));
        if (!parts.empty() && parts.back().piece.offset + parts.back().piece.size == piece.offset)
            parts.back().piece.size += piece.size;
        else if (piece.size > 0) parts.push_back({total, piece});
        total += piece.size;
    }
    const auto shared = std::make_shared<const std::vector<Part>>(std::move(parts));
    Source whole{std::move(name), total, {}, {}};
    whole.read_into = [source, shared, label = whole.name, total](std::uint64_t offset, std::uint64_t count,
                                                                  char* target) {
        if (offset > total || count > total - offset)
            throw FormatError(
                label, {.offset = total},
                fmt::format("the data end here, expected {} bytes from byte {}; they are truncated or damaged", count,
                            offset));
        auto next = std::upper_bound(shared->begin(), shared->end(), offset,
                                     [](std::uint64_t place, const Part& part) { return place < part.at; });
        for (; count > 0; ++next) {
            const auto& [at, piece] = *std::prev(next);
            const auto within = offset - at, taken = std::min(count, piece.size - within);
            source.read_into(piece.offset + within, taken, target);
            offset += taken;
            count -= taken;
            target += taken;
        }
    };
    return whole;
}

}  // namespace setae::bytes
