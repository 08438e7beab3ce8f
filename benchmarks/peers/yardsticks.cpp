// SPDX-License-Identifier: GPL-3.0-or-later
#include <fftw3.h>

#include <cstring>
#include <memory>

#include "tasks.hpp"

namespace setae::benchmarks {
namespace {

/// FFTW's real transform of the map on one core, plan included.
Array1D transform(const TaskInput& input) {
    const auto& heights = input.map().heights;
    const auto nx = static_cast<int>(heights.rows()), ny = static_cast<int>(heights.cols());
    const auto modes = static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny / 2 + 1);
    const std::unique_ptr<fftw_complex, decltype(&fftw_free)> spectrum(fftw_alloc_complex(modes), fftw_free);
    const auto plan = fftw_plan_dft_r2c_2d(nx, ny, const_cast<double*>(heights.data()), spectrum.get(),
                                           FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    return {};
}

/// Every height read once, on one core.
Array1D read(const TaskInput& input) { return Array1D::Constant(1, input.map().heights.sum()); }

/// The map copied into memory that is new, on one core.
Array1D copy(const TaskInput& input) {
    const auto& heights = input.map().heights;
    const std::unique_ptr<double[]> other(new double[static_cast<std::size_t>(heights.size())]);
    std::memcpy(other.get(), heights.data(), static_cast<std::size_t>(heights.size()) * sizeof(double));
    return Array1D::Constant(1, other[0]);
}

}  // namespace

const std::vector<Task>& yardsticks() {
    static const std::vector<Task> list{{"transform", "bare FFTW r2c", transform},
                                        {"read", "reading the map once", read},
                                        {"copy", "copying the map", copy}};
    return list;
}

}  // namespace setae::benchmarks
