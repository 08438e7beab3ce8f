// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/expanded_source.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

struct Expansion {
    std::string name;
    std::uint64_t size = 0;
    std::function<std::string()> expand;
    std::mutex guard;
    std::string content;
    bool done = false;

    const std::string& expanded() {
        const std::lock_guard lock(guard);
        if (!done) {
            content = expand();
            if (content.size() != size)
                throw FormatError(
                    name, {.offset = content.size()},
                    fmt::format("compressed data contain {} bytes, but the header states {}; the file is damaged",
                                content.size(), size));
            done = true;
        }
        return content;
    }
};

}  // namespace

Source expanded_source(std::string name, std::uint64_t size, std::function<std::string()> expand) {
    auto expansion = std::make_shared<Expansion>();
    expansion->name = name;
    expansion->size = size;
    expansion->expand = std::move(expand);
    return {std::move(name), size, {}, [expansion](std::uint64_t offset, std::uint64_t count, char* target) {
                if (offset > expansion->size || count > expansion->size - offset)
                    throw FormatError(expansion->name, {.offset = expansion->size},
                                      fmt::format("the data end here, expected {} bytes from byte {}", count, offset));
                std::copy_n(expansion->expanded().data() + offset, count, target);
            }};
}

}  // namespace setae::bytes
