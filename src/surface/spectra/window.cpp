// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/window.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::spectra {
namespace {

constexpr std::array<std::pair<Window, const char*>, 5> window_names{{{Window::automatic, "automatic"},
                                                                      {Window::none, "none"},
                                                                      {Window::hann, "hann"},
                                                                      {Window::blackman_harris, "blackman_harris"},
                                                                      {Window::radial_hann, "radial_hann"}}};

template <std::size_t n>
std::array<double, n> power_preserving(std::array<double, n> coefficients) {
    double power = coefficients[0] * coefficients[0];
    for (std::size_t m = 1; m < n; ++m) power += 0.5 * coefficients[m] * coefficients[m];
    for (double& a : coefficients) a /= std::sqrt(power);
    return coefficients;
}

}  // namespace

std::span<const double> cosine_coefficients(Window window) {
    static constexpr std::array<double, 1> none{1.0};
    static const auto hann = power_preserving<2>({1.0, -1.0});
    static const auto blackman_harris = power_preserving<4>({0.35875, -0.48829, 0.14128, -0.01168});
    switch (window) {
        case Window::none: return none;
        case Window::hann: return hann;
        case Window::blackman_harris: return blackman_harris;
        default:
            throw InvalidArgument(
                fmt::format("window {} is not a sum of cosines along one direction; expected none, hann "
                            "or blackman_harris",
                            name(window)));
    }
}

Array1D window_values(Window window, Index n) {
    const auto coefficients = cosine_coefficients(window);
    Array1D values = Array1D::Zero(n);
    for (Index j = 0; j < n; ++j)
        for (std::size_t m = 0; m < coefficients.size(); ++m) {
            // the phase m j mod n keeps the cosine exactly periodic
            const auto phase = static_cast<double>((static_cast<Index>(m) * j) % n) / static_cast<double>(n);
            values[j] += coefficients[m] * std::cos(2.0 * pi * phase);
        }
    return values * std::sqrt(static_cast<double>(n) / values.square().sum());
}

Window resolved(Window window, bool periodic) {
    if (window != Window::automatic) return window;
    return periodic ? Window::none : Window::hann;
}

Window window_from_name(const std::string& text) {
    for (const auto& [window, known] : window_names)
        if (text == known) return window;
    throw InvalidArgument(
        fmt::format("'{}' is not a window; expected automatic, none, hann, blackman_harris or radial_hann", text));
}

std::string name(Window window) {
    for (const auto& [known, text] : window_names)
        if (known == window) return text;
    throw InternalError("window without a name");
}

}  // namespace setae::spectra
