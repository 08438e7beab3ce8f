// SPDX-License-Identifier: GPL-3.0-or-later
#include "synthesize/synthesis_options.hpp"

#include "setae/core/units.hpp"

namespace setae::cli {

void SynthesisOptions::add_to(Options& options) {
    options.add("--hurst", hurst, "Hurst exponent H of a self-affine spectrum, 0 < H <= 1").within(domain::share);
    options.add("--rolloff", rolloff, "roll-off wavelength; longer ones have a flat spectrum")
        .quantity(positive(dimension::length));
    options.add("--short-cutoff", short_cutoff, "shortest wavelength").quantity(positive(dimension::length));
    options.add("--long-cutoff", long_cutoff, "longest wavelength, none by default")
        .quantity(positive(dimension::length));
    options.add("--rms-height", rms_height, "of the spectrum, such as 20 nm").quantity(positive(dimension::length));
    options.add("--rms-slope", rms_slope, "of the spectrum").quantity(positive(dimension::none));
    options.add("--plateau", plateau, "C_iso below the roll-off, such as \"5e-27 m4\"")
        .quantity(positive(dimension::power_spectrum_2d));
    options.add("--spectrum,table", spectrum,
                "table of q and C_iso [m4] or C1D [m3] instead of a self-affine spectrum");
    options.add(
        "--unit", spectrum_unit,
        "of the table's columns where its header has none, such as \"1/um, nm3\" or \"frequency 1/um, one-sided nm3\"");
    options.add("--pixels", pixels, "points along x and y, such as 1024x512; one number for both")
        .default_shown()
        .read_by([](const std::string& text) { (void)answers::point_counts(text); });
    const auto extent = [](const std::string& text) { (void)answers::extents(text); };
    options.add("--size", size, "extent, such as \"5 um\" or \"5 um x 2 um\"").read_by(extent);
    options
        .add("--window-of", window_of,
             "make a periodic surface of this extent and write --size of it, which is not periodic")
        .read_by(extent);
    options.add("--seed", seed, "same seed, same surface").default_shown();
    options.flag("--line", line, "a line on such a surface");
    options.flag("--exact-rms", exact_rms, "scale the heights to the spectrum's rms height, or to --rms-height");
    options.add("--amplitudes", amplitudes, "gaussian, or exact: every mode as the spectrum says")
        .one_of({"gaussian", "exact"});
    options.add("--stretch", stretch, "features this many times longer along --angle").default_shown();
    options.add("--skewness", skewness, "of the heights of a surface, which keeps its spectrum; default 0");
    options.add("--kurtosis", kurtosis, "of the heights of a surface; default 3, Gaussian");
    options.add("--angle", angle, "of the long direction against x, degrees").default_shown();
}

}  // namespace setae::cli
