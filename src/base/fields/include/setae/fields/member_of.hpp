// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::fields::detail {

/// Class and type of a member, by a pointer to it.
template <class T>
struct MemberOf;
template <class Of, class Value>
struct MemberOf<Value Of::*> {
    using Object = Of;
    using Type = Value;
};

}  // namespace setae::fields::detail
