// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "setae/io/source.hpp"

namespace setae::io::tests {

/// A file larger than the memory of a test, zeros but for its beginning and its end, that counts the bytes read of it.
struct CountedSource {
    Source source;
    std::shared_ptr<std::atomic<std::uint64_t>> bytes_read;
};

[[nodiscard]] inline CountedSource counted_source(const std::string& begin, std::uint64_t zeros, const std::string& end) {
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

/// A source that begins with `head`, goes on with zeros up to `size`, and counts the bytes that are asked for.
    std::shared_ptr<std::atomic<std::uint64_t>> read = std::make_shared<std::atomic<std::uint64_t>>(0);

    CountedSource(const std::string& head, std::uint64_t size) {
        source = {"large", size, {}, [head, counter = read](std::uint64_t offset, std::uint64_t count, char* target) {
                      *counter += count;
                      std::fill_n(target, count, '\0');
                      if (offset < head.size()) std::copy_n(head.data() + offset, std::min<std::uint64_t>(count, head.size() - offset), target);
                  }};
    }

}  // namespace setae::io::tests
