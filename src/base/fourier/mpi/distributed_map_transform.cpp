// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/distributed_map_transform.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>

#include <fftw3-mpi.h>
#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/fourier/buffer.hpp"

namespace setae::fourier {
namespace {

constexpr std::ptrdiff_t doubles_per_value = 2;

/// Lines of the half spectrum and rows of the map on this rank.
struct Shares {
    std::ptrdiff_t lines = 0, first_line = 0, rows = 0, first_row = 0;
    std::ptrdiff_t doubles = 0;  ///< of the buffer of the transpose
};

void start_fftw() {
    static std::once_flag started;
    std::call_once(started, fftw_mpi_init);
}

Shares shares(MPI_Comm communicator, Index modes, Index nx) {
    start_fftw();
    const std::array<std::ptrdiff_t, 2> shape{modes, nx};
    Shares own;
    own.doubles = fftw_mpi_local_size_many_transposed(2, shape.data(), doubles_per_value, FFTW_MPI_DEFAULT_BLOCK,
                                                      FFTW_MPI_DEFAULT_BLOCK, communicator, &own.lines, &own.first_line,
                                                      &own.rows, &own.first_row);
    return own;
}

/// Transposes lines of nx modes each to rows of `modes` values each, in place.
void transpose(MPI_Comm communicator, Index modes, Index nx, double* values) {
    const auto plan = fftw_mpi_plan_many_transpose(modes, nx, doubles_per_value, FFTW_MPI_DEFAULT_BLOCK,
                                                   FFTW_MPI_DEFAULT_BLOCK, values, values, communicator, FFTW_ESTIMATE);
    if (plan == nullptr)
        throw InternalError(fmt::format("the parallel transpose of {} x {} values is not possible", modes, nx));
    fftw_execute(plan);
    fftw_destroy_plan(plan);
}

template <class Body>
std::exception_ptr failure_of(const Body& body) {
    try {
        body();
    } catch (...) {
        return std::current_exception();
    }
    return nullptr;
}

}  // namespace

void rethrow_together(MPI_Comm communicator, const std::exception_ptr& own) {
    int failed = own ? 1 : 0, failed_anywhere = 0;
    MPI_Allreduce(&failed, &failed_anywhere, 1, MPI_INT, MPI_MAX, communicator);
    if (own) std::rethrow_exception(own);
    if (failed_anywhere != 0)
        throw InternalError("another rank of the communicator failed; see the message of that rank");
}

MapSlab distributed_inverse_transform_map(MPI_Comm communicator, const SpectrumLine& load, Index nx, Index ny,
                                          parallel::Threads threads) {
    if (nx < 1 || ny < 1)
        throw InvalidArgument(fmt::format("a transform to {} x {} points; expected at least 1 x 1", nx, ny));
    const InverseRealTransform along_y(ny);
    const ComplexTransform along_x(nx, ComplexTransform::Sign::plus);
    const Index modes = along_y.modes();
    const auto own = shares(communicator, modes, nx);

    // complex values are accessed as pairs, as the standard allows; lines have a separate buffer, because the transform
    // requires alignment
    Buffer<Complex> values(static_cast<std::size_t>(own.doubles / doubles_per_value + 1));
    rethrow_together(communicator, failure_of([&] {
                         parallel::for_each_index(static_cast<std::size_t>(own.lines), threads, [&](std::size_t line) {
                             thread_local Buffer<Complex> buffer;
                             buffer.resize(static_cast<std::size_t>(nx));
                             load(static_cast<Index>(own.first_line) + static_cast<Index>(line), buffer.data());
                             along_x.apply(buffer.data());
                             std::copy(buffer.begin(), buffer.end(),
                                       values.begin() + static_cast<std::ptrdiff_t>(line) * nx);
                         });
                     }));
    transpose(communicator, modes, nx, reinterpret_cast<double*>(values.data()));

    MapSlab slab{static_cast<Index>(own.first_row), Array2D(own.rows, ny)};
    parallel::for_each_index(static_cast<std::size_t>(own.rows), threads, [&](std::size_t row) {
        thread_local Buffer<Complex> half;
        thread_local Buffer<double> heights;
        half.resize(static_cast<std::size_t>(modes));
        heights.resize(static_cast<std::size_t>(ny));
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(row) * modes, modes, half.begin());
        half.front() = half.front().real();
        if (ny % 2 == 0) half.back() = half.back().real();
        along_y.apply(half.data(), heights.data());
        std::copy(heights.begin(), heights.end(), slab.heights.row(static_cast<Index>(row)).data());
    });
    return slab;
}

}  // namespace setae::fourier
