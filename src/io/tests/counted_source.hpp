// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "setae/io/source.hpp"

namespace setae::io::tests {

/// A source that begins with `head`, goes on with zeros up to `size`, and counts the bytes that are asked for.
struct CountedSource {
    Source source;
    std::shared_ptr<std::atomic<std::uint64_t>> read = std::make_shared<std::atomic<std::uint64_t>>(0);

    CountedSource(const std::string& head, std::uint64_t size) {
        source = {"large", size, {}, [head, counter = read](std::uint64_t offset, std::uint64_t count, char* target) {
                      *counter += count;
                      std::fill_n(target, count, '\0');
                      if (offset < head.size()) std::copy_n(head.data() + offset, std::min<std::uint64_t>(count, head.size() - offset), target);
                  }};
    }
};

}  // namespace setae::io::tests
