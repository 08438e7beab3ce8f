// SPDX-License-Identifier: GPL-3.0-or-later
#include "params/texture_options.hpp"

namespace setae::cli {

void TextureOptions::add_to(Options& options) {
    options.ask<answers::TextureRequest>(*this);
    options.output("--format", format, "format of a standard's parameters; default: text")
        .one_of({"text", "md", "tsv", "latex", "json"});
}

}  // namespace setae::cli
