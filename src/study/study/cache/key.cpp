// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/cache/key.hpp"

#include <fmt/format.h>

#include "setae/bytes/digest.hpp"

namespace setae::cache {

KeyBuilder& KeyBuilder::add(std::string_view name, std::string_view value) {
    parts_ += fmt::format("{} {} {} {}\n", name.size(), name, value.size(), value);
    return *this;
}

std::string KeyBuilder::key() const { return bytes::sha256(parts_); }

}  // namespace setae::cache
