// SPDX-License-Identifier: GPL-3.0-or-later
#include "psd/psd_fit.hpp"

namespace setae::cli {

void FitOptions::add_to(Options& options) {
    options.flag("--fit", wanted, "fit a self-affine surface: H, C_0, roll-off");
    options.add("--fit-range", range, "wavevectors fitted [1/m], such as 1e5:1e8").read_by([](const std::string& text) {
        (void)answers::wavevector_range(text);
    });
    options.flag("--no-rolloff", no_rolloff, "fit a power law without roll-off");
    options.flag("--short-cutoff", short_cutoff, "also fit where the spectrum ends");
}

}  // namespace setae::cli
