// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Results that are kept between runs, as the JSON of `setae cache` has them.

#include <array>
#include <string>

#include "setae/cache/store.hpp"
#include "setae/fields/describe.hpp"
#include "setae/study/provenance.hpp"

namespace setae::answers {

/// Results in a folder.
struct KeptResults {
    std::string folder;
    cache::Content content;
};

/// Results that were removed from a folder.
struct RemovedResults {
    std::string folder;
    cache::Content content;
};

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::answers::KeptResults> {
    using T = answers::KeptResults;
    static constexpr std::array rows{
        field<&T::folder>("folder", "folder of the cache"),
        made<T>("entries", "number of results in the cache", [](const T& of) { return of.content.entries; }),
        made<T>("of_other_versions", "number of results of other versions",
                [](const T& of) { return of.content.of_other_versions; }),
        made<T>("bytes", "size of the results in bytes", [](const T& of) { return of.content.bytes; }),
        made<T>("version", "version of the program", [](const T&) { return study::version(); }),
        inner<&T::content>(),
    };
    static constexpr Description description{"", "results that are kept between runs", rows};
};
static_assert(setae::fields::complete<setae::answers::KeptResults>);

template <>
struct setae::fields::Described<setae::answers::RemovedResults> {
    using T = answers::RemovedResults;
    static constexpr std::array rows{
        field<&T::folder>("folder", "folder of the cache"),
        made<T>("removed_entries", "number of results that were removed",
                [](const T& of) { return of.content.entries; }),
        made<T>("of_other_versions", "number of removed results of other versions",
                [](const T& of) { return of.content.of_other_versions; }),
        made<T>("removed_bytes", "size of the removed results in bytes", [](const T& of) { return of.content.bytes; }),
        made<T>("version", "version of the program", [](const T&) { return study::version(); }),
        inner<&T::content>(),
    };
    static constexpr Description description{"", "with `prune` and `clear` the results that were removed", rows};
};
static_assert(setae::fields::complete<setae::answers::RemovedResults>);
