// SPDX-License-Identifier: GPL-3.0-or-later
#include "params/texture_options.hpp"

#include "setae/core/units.hpp"

namespace setae::cli {

void TextureOptions::add_to(Options& options) {
    options
        .add("--standard", standard,
             "parameters of a standard: iso25178 (maps) or iso21920 (lines; maps: mean over scan lines)")
        .one_of({"iso25178", "iso21920"});
    options.add("--only", only, "these parameters of the standard only, by symbol or name, such as \"Sq, Sdr\"");
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

}  // namespace setae::cli
