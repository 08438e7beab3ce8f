// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Formats that setae reads and writes, as the JSON of `setae formats` has them.

#include <array>

#include "setae/fields/describe.hpp"
#include "setae/formats/format.hpp"
#include "setae/imaging/micrograph.hpp"
#include "setae/tables/force_curve.hpp"

namespace setae::answers {

/// Every format that is read or written.
struct FormatList {};

}  // namespace setae::answers

namespace setae::fields {

namespace detail {

/// Rows of a format that is read only.
template <class T>
inline constexpr std::array rows_of_format{
    field<&T::identifier>("identifier", "identifier of the format"),
    field<&T::name>("name", "name of the format"),
    field<&T::extensions>("extensions", "endings of the files"),
    field<&T::description>("description", "instruments and content that is read"),
    field<&T::reference>("reference", "description of the layout"),
    field<&T::tested_on_real_files>("tested_on_real_files",
                                    "whether the reader was tested on files of an instrument; otherwise only on files "
                                    "made from the description of the format"),
};

}  // namespace detail

template <>
struct Described<formats::Format> {
    using T = formats::Format;
    static constexpr std::array rows{
        field<&T::identifier>("identifier", "identifier of the format"),
        field<&T::name>("name", "name of the format"),
        field<&T::extensions>("extensions", "endings of the files"),
        field<&T::description>("description", "instruments and content that is read"),
        field<&T::heights>("heights", "conversion of stored values to heights"),
        field<&T::orientation>("orientation", "which corner of the map is first"),
        field<&T::not_read>("not_read", "content that is not read"),
        field<&T::reference>("reference", "description of the layout"),
        made<T>("reads", "whether setae reads the format", [](const T&) { return true; }),
        made<T>("writes", "whether setae writes the format", [](const T& of) { return of.writes(); }),
        field<&T::tested_on_real_files>("tested_on_real_files",
                                        "whether the reader was tested on files of an instrument; otherwise only on "
                                        "files made from the description of the format"),
        inner<&T::carries_scale>(),
        inner<&T::read_elsewhere>(),
        inner<&T::is_container>(),
        inner<&T::detect>(),
        inner<&T::open>(),
        inner<&T::write>(),
    };
    static constexpr Description description{"", "a format of topographies", rows};
};
static_assert(complete<formats::Format>);

template <>
struct Described<tables::ForceCurveFormat> {
    static constexpr auto& rows = detail::rows_of_format<tables::ForceCurveFormat>;
    static constexpr Description description{"", "a format of force curves", rows};
};
static_assert(complete<tables::ForceCurveFormat>);

template <>
struct Described<imaging::MicrographFormat> {
    static constexpr auto& rows = detail::rows_of_format<imaging::MicrographFormat>;
    static constexpr Description description{"", "a format of micrographs", rows};
};
static_assert(complete<imaging::MicrographFormat>);

template <>
struct Described<answers::FormatList> {
    using T = answers::FormatList;
    static constexpr std::array rows{
        made<T>("formats", "formats of topographies", [](const T&) -> const auto& { return formats::formats(); }),
        made<T>("force_curves", "formats of force curves",
                [](const T&) -> const auto& { return tables::force_curve_formats(); }),
        made<T>("micrographs", "formats of micrographs",
                [](const T&) -> const auto& { return imaging::micrograph_formats(); }),
    };
    static constexpr Description description{"", "formats that are read and written", rows};
};

}  // namespace setae::fields
