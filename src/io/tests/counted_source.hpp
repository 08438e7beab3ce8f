// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "setae/io/source.hpp"

namespace setae::io::tests {

/// A file, perhaps larger than the memory of a test, that counts the bytes read of it.
struct CountedSource {
    Source source;
    std::shared_ptr<std::atomic<std::uint64_t>> bytes_read;
};

/// Zeros but for its beginning and its end.
[[nodiscard]] inline CountedSource counted_source(const std::string& begin, std::uint64_t zeros = 0, const std::string& end = {}) {
    CountedSource counted{{"large", begin.size() + zeros + end.size(), {}, {}}, std::make_shared<std::atomic<std::uint64_t>>(0)};
    counted.source.read_into = [begin, zeros, end, read = counted.bytes_read](std::uint64_t offset, std::uint64_t count, char* target) {
        *read += count;
        for (std::uint64_t k = 0; k < count; ++k) {
            const auto at = offset + k;
            target[k] = at < begin.size() ? begin[at] : at < begin.size() + zeros ? '\0' : end[at - begin.size() - zeros];
        }
    };
    return counted;
}

}  // namespace setae::io::tests
