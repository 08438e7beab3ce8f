// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace setae::cache {

/// Builds the key of a result from everything it depends on, in order.
///
/// Each part enters with its name and length, so that no two different lists of parts share a key.
class KeyBuilder {
public:
    /// kind: of the result, such as "measurement".
    explicit KeyBuilder(std::string_view kind) { add("kind", kind); }
    KeyBuilder& add(std::string_view name, std::string_view value);
    /// SHA-256 of the parts, 64 hexadecimal digits.
    [[nodiscard]] std::string key() const;

private:
    std::string parts_;
};

}  // namespace setae::cache
