// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/format_list.hpp"

#include <nlohmann/json.hpp>

#include "setae/formats/format.hpp"
#include "setae/imaging/micrograph.hpp"
#include "setae/tables/force_curve.hpp"

namespace setae::answers {
namespace {

/// Formats that are only read.
template <class Formats>
output::Json list_of(const Formats& formats) {
    output::Json list = output::Json::array();
    for (const auto& f : formats)
        list.push_back({{"identifier", f.identifier},
                        {"name", f.name},
                        {"extensions", f.extensions},
                        {"description", f.description},
                        {"reference", f.reference},
                        {"tested_on_real_files", f.tested_on_real_files}});
    return list;
}

output::Json topographies_json() {
    auto list = output::Json::array();
    for (const auto& f : formats::formats())
        list.push_back({{"identifier", f.identifier},
                        {"name", f.name},
                        {"extensions", f.extensions},
                        {"description", f.description},
                        {"heights", f.heights},
                        {"orientation", f.orientation},
                        {"not_read", f.not_read},
                        {"reference", f.reference},
                        {"reads", true},
                        {"writes", f.writes()},
                        {"tested_on_real_files", f.tested_on_real_files}});
    return list;
}

}  // namespace

output::Json formats_json() {
    return {{"formats", topographies_json()},
            {"force_curves", list_of(tables::force_curve_formats())},
            {"micrographs", list_of(imaging::micrograph_formats())}};
}

}  // namespace setae::answers
