// SPDX-License-Identifier: GPL-3.0-or-later
#include "qep_samples.hpp"

#include <cmath>
#include <cstdint>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

FormatSample sample(const std::string& name, const Members& members, std::size_t channel, const Array1D& heights,
                    double size) {
    return {.format = "qep",
            .name = name,
            .content = zip_archive(members),
            .channel = channel,
            .shape = {heights.size()},
            .size = {size},
            .heights = heights * units::mm};
}

}  // namespace

std::string marwin_profile(const Array1D& positions, const Array1D& heights, const std::string& probe_radius) {
    ByteBuilder file;
    file.text("[p3dlin]").pad_to(0x14).number(static_cast<std::int32_t>(positions.size())).pad_to(0xc4);
    const std::vector<std::string> texts{"Kontur",
                                         ">DateTime=2026-03-20  02:44:41  (Mitteleurop\xe4ische Zeit)",
                                         ">MachineName=MarSurf LD 260",
                                         ">ProductName=MarWin",
                                         ">ProductVersion=12.06",
                                         ">ProbeRadius=" + probe_radius};
    file.number(static_cast<std::int32_t>(texts.size()));
    for (const auto& text : texts) file.number(static_cast<std::int32_t>(text.size())).text(text);
    file.text("between", 19).text("[sellsg]").text("selected", 33).text("[Trajec]").text("", 41);
    for (const double x : positions) file.number(x);
    for (Index i = 0; i < positions.size(); ++i) file.number(0.125);
    for (const double h : heights) file.number(std::isnan(h) ? -99.0 : h);
    for (const double h : heights) file.number(std::isnan(h) ? 1.0f : 0.0f);
    return file.content();
}

std::vector<FormatSample> qep_samples() {
    constexpr Index n = 9;
    const Array1D even = 10.0 + 0.25 * Array1D::LinSpaced(n, 0.0, n - 1.0);
    Array1D heights = lopsided_heights(n, 1, 0.001);
    heights[3] = undefined;
    Array1D uneven = even;
    uneven[1] += 0.1;
    const Array1D kept = (Array1D(n - 1) << heights.head(3), heights.tail(n - 4)).finished();
    const auto measured = marwin_profile(even, heights, "0.025");
    const Array1D twice = 2.0 * heights;
    const auto reference = marwin_profile(even.reverse(), twice.reverse(), "0.025");
    const double size = n * 0.25 * units::mm, shorter = (n - 1) * 0.25 * units::mm;
    return {sample("equal steps", {{"Kontur1.prf", measured}, {"remarks.xml", "<x/>"}}, 0, heights, size),
            sample("uneven steps", {{"Kontur1.prf", marwin_profile(uneven, heights, "0.025")}}, 0, kept, shorter),
            sample("reference, stored backwards",
                   {{"Kontur1.prf", measured}, {"qe_contour_reference_profil_001.tmp", reference}}, 1, twice, size)};
}

}  // namespace setae::formats::tests
