// SPDX-License-Identifier: GPL-3.0-or-later
#include "params/texture_options.hpp"

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::cli {

using texture::ProfileKind;
using texture::TextureParameter;

void TextureOptions::add_to(Options& options) {
    options
        .add("--standard", standard,
             "parameters of a standard: iso25178 (maps) or iso21920 (lines; maps: mean over scan lines)")
        .one_of({"iso25178", "iso21920"});
    options.add("--s-filter", s_filter, "nesting index of the Gaussian S-filter (λs), such as 2.5um")
        .quantity(positive(dimension::length));
    options
        .add(
            "--l-filter", l_filter,
            "nesting index of the Gaussian L-filter (λc), such as 0.8mm; iso21920: \"default\", both filters by Ra (ISO 4288)")
        .read_by([](const std::string& text) {
            if (text != "default") (void)parse_quantity(text, positive(dimension::length));
        });
    options
        .add("--section-length", section_length,
             "iso21920: length of a section; default the L-filter's nesting index, else all")
        .quantity(positive(dimension::length));
    options.add("--profile", kind, "iso21920: primary, waviness or roughness (default)")
        .one_of({"primary", "waviness", "roughness"});
    options
        .add("--averages", averages,
             "iso21920: over the evaluation length (2021, default) or over sections (ISO 4287:1997)")
        .one_of({"evaluation_length", "sections"});
    options
        .add("--mean-line", mean_line,
             "iso21920: heights from their mean (default) or from zero, for profiles an instrument filtered")
        .one_of({"mean", "zero"});
    options
        .add("--between", between,
             "material ratio of triangles between points (linear, default) or of points (nothing)")
        .one_of({"linear", "nothing"});
    options.add("--material-height", material_height, "c of Smr(c), Rmr(c) over the mean, such as 0.2um; default 0")
        .quantity(dimension::length);
    options.add("--material-ratio", material_ratio, "p of Smc(p), Rmc(p), 0 … 1; default 0.5, the median")
        .between(0.0, 1.0);
    options.add("--format", format, "how a standard's parameters are written: text (default), md, tsv, latex, json")
        .one_of({"text", "md", "tsv", "latex", "json"});
}

bool TextureOptions::asked() const {
    if (!standard.empty()) return true;
    for (const auto& option :
         {s_filter, l_filter, section_length, kind, averages, mean_line, between, format, material_height})
        if (!option.empty() || material_ratio)
            throw InvalidArgument(
                "--s-filter, --l-filter, --section-length, --profile, --averages, --mean-line, --between, --format, --material-height and "
                "--material-ratio are of a standard's parameters; "
                "give --standard iso25178 or --standard iso21920");
    return false;
}

texture::Filters TextureOptions::filters() const {
    texture::Filters filters;
    if (!s_filter.empty()) filters.s_filter = parse_quantity(s_filter, dimension::length);
    if (l_filter == "default" && standard != "iso21920")
        throw InvalidArgument("--l-filter default is of iso21920; give a length, such as 0.8mm");
    if (!l_filter.empty() && l_filter != "default") filters.l_filter = parse_quantity(l_filter, dimension::length);
    return filters;
}

texture::ProfileOptions TextureOptions::profile() const {
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
    return options;
}

std::vector<TextureParameter> TextureOptions::parameters_of(const topography::Measurement& measurement,
                                                            parallel::Threads threads) const {
    const auto of_lines = profile();
    if (standard == "iso25178")
        return texture::areal_parameters(measurement,
                                         {.filters = of_lines.filters,
                                          .between = of_lines.between,
                                          .material_height = of_lines.material_height,
                                          .material_ratio = of_lines.material_ratio},
                                         threads);
    const auto* map = std::get_if<topography::HeightMap>(&measurement);
    return map ? texture::mean_profile_parameters(*map, of_lines, threads)
               : texture::profile_parameters(measurement, of_lines, threads);
}

}  // namespace setae::cli
