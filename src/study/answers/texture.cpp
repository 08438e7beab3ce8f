// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/texture.hpp"

#include <algorithm>

#include "setae/answers/words.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::answers {

using texture::ProfileKind;
using texture::TextureParameter;

bool TextureRequest::asked() const {
    if (!standard.empty()) return true;
    for (const auto& option :
         {s_filter, l_filter, section_length, kind, averages, mean_line, between, format, material_height, only})
        if (!option.empty() || material_ratio)
            throw InvalidArgument(
                "`only`, `s_filter`, `l_filter`, `section_length`, `profile`, `averages`, `mean_line`, `between`, `format`, "
                "`material_height` and `material_ratio` are of a standard's parameters; "
                "give `standard = iso25178` or `standard = iso21920`");
    return false;
}

texture::Filters TextureRequest::filters() const {
    texture::Filters filters;
    if (!s_filter.empty()) filters.s_filter = parse_quantity(s_filter, dimension::length);
    if (l_filter == "default" && standard != "iso21920")
        throw InvalidArgument("`l_filter = default` is of iso21920; give a length, such as 0.8mm");
    if (!l_filter.empty() && l_filter != "default") filters.l_filter = parse_quantity(l_filter, dimension::length);
    return filters;
}

texture::ProfileOptions TextureRequest::profile() const {
    texture::ProfileOptions options;
    options.filters = filters();
    options.default_filters = l_filter == "default";
    options.kind = kind == "primary"    ? ProfileKind::primary
                   : kind == "waviness" ? ProfileKind::waviness
                                        : ProfileKind::roughness;
    if (!section_length.empty()) options.section_length = parse_quantity(section_length, dimension::length);
    if (averages == "sections") options.averages = texture::Averages::sections;
    if (mean_line == "zero") options.mean_line = texture::MeanLine::zero;
    if (!material_height.empty()) options.material_height = parse_quantity(material_height, dimension::length);
    options.material_ratio = material_ratio.value_or(0.5);
    options.between = between == "nothing" ? texture::Between::nothing : texture::Between::linear;
    if (!only.empty()) options.only = chosen();
    return options;
}

std::vector<std::string> TextureRequest::chosen() const {
    const char letter = kind == "primary" ? 'P' : kind == "waviness" ? 'W' : 'R';
    return texture::chosen_parameters(
        only, standard == "iso25178" ? texture::Standard::iso25178 : texture::Standard::iso21920, letter);
}

std::vector<TextureParameter> TextureRequest::parameters_of(const topography::Measurement& measurement,
                                                            parallel::Threads threads) const {
    const auto of_lines = profile();
    if (standard == "iso25178")
        return texture::areal_parameters(measurement,
                                         {.filters = of_lines.filters,
                                          .between = of_lines.between,
                                          .material_height = of_lines.material_height,
                                          .material_ratio = of_lines.material_ratio,
                                          .only = of_lines.only},
                                         threads);
    const auto* map = std::get_if<topography::HeightMap>(&measurement);
    return map ? texture::mean_profile_parameters(*map, of_lines, threads)
               : texture::profile_parameters(measurement, of_lines, threads);
}

TextureAnswer texture_of(const study::SurfaceInput& surface, const TextureRequest& request, parallel::Threads threads,
                         bool every_measurement) {
    if (request.standard.empty()) throw InvalidArgument("no standard; expected iso25178 or iso21920");
    using Asked = fields::Asked<TextureRequest>;
    require_word("standard", request.standard, Asked::standards);
    require_word("profile", request.kind, Asked::profiles);
    require_word("averages", request.averages, Asked::averages);
    require_word("mean line", request.mean_line, Asked::mean_lines);
    require_word("between", request.between, Asked::between);
    if (!request.only.empty()) (void)request.chosen();
    TextureAnswer answer;
    for (const auto& input : surface.measurements) {
        try {
            for (const auto& source : study::measurement_sources(input)) {
                const auto prepared = source.prepare();
                answer.list.push_back({input.file, topography::metadata(prepared.measurement).name,
                                       request.parameters_of(prepared.measurement, threads)});
                answer.alerts.insert(answer.alerts.end(), prepared.alerts.begin(), prepared.alerts.end());
            }
        } catch (const std::exception& error) {
            if (every_measurement) throw;
            answer.failures.push_back(reason_of(error));
        }
    }
    for (const auto& measured : answer.list)
        for (const auto& row : measured.parameters)
            for (const auto& alert : row.quantity.alerts)
                if (std::find(answer.alerts.begin(), answer.alerts.end(), alert) == answer.alerts.end())
                    answer.alerts.push_back(alert);
    return answer;
}

std::vector<TextureEntry> texture_entries(const TextureAnswer& answer) {
    std::vector<TextureEntry> entries;
    for (const auto& measured : answer.list)
        for (const auto& parameter : measured.parameters) entries.push_back({&measured, &parameter});
    return entries;
}

}  // namespace setae::answers
