// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <string>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "running_calls.hpp"
#include "setae/core/arrays.hpp"
#include "setae/core/table.hpp"
#include "setae/parallel/cancellation.hpp"

namespace setae::python {

namespace nb = nanobind;

/// Result of `work`, which runs on its own thread without the lock of the interpreter. Other threads of Python
/// continue. Ctrl-C requests work to stop; KeyboardInterrupt is raised after it has stopped.
///
/// work: its argument is the flag that requests the stop. Loops of for_each_index() check this flag.
template <class Work>
auto unlocked(Work&& work) {
    constexpr auto between_looks = std::chrono::milliseconds(50);
    std::atomic<bool> cancelled{false};
    bool interrupted = false;
    const RunningCall call(cancelled);
    auto result = [&] {
        const nb::gil_scoped_release released;
        auto future = std::async(std::launch::async, [&] {
            const parallel::CancellationScope scope(cancelled);
            return work(static_cast<const std::atomic<bool>&>(cancelled));
        });
        while (future.wait_for(between_looks) != std::future_status::ready) {
            const nb::gil_scoped_acquire locked;
            if (interrupted || PyErr_CheckSignals() == 0) continue;
            PyErr_Clear();
            interrupted = cancelled = true;
        }
        if (cancelled) {
            try {
                (void)future.get();
            } catch (...) {
                // stopped, with or without a result
            }
            throw Interrupted();
        }
        return future.get();
    }();
    return result;
}

/// Result of work that takes at most a millisecond, on this thread: starting a thread would take as long.
template <class Work>
auto unlocked_here(Work&& work) {
    std::atomic<bool> cancelled{false};
    const RunningCall call(cancelled);
    const nb::gil_scoped_release released;
    return work(static_cast<const std::atomic<bool>&>(cancelled));
}

using ReadOnly1D = nb::ndarray<nb::numpy, const double, nb::ndim<1>, nb::c_contig>;
using ReadOnly = nb::ndarray<nb::numpy, const double, nb::c_contig>;

/// An array of NumPy that uses the memory of a series, which `owner` keeps alive.
inline ReadOnly1D view(const Array1D& values, nb::handle owner) {
    return ReadOnly1D(values.data(), {static_cast<std::size_t>(values.size())}, owner);
}

/// Columns by name that use the memory of a table, which `owner` keeps alive.
inline nb::typed<nb::dict, nb::str, ReadOnly1D> columns(const Table& table, nb::handle owner) {
    nb::dict named;
    for (const auto& column : table.columns) named[nb::cast(column.name)] = nb::cast(view(column.values, owner));
    return named;
}

inline nb::typed<nb::dict, nb::str, nb::str> units(const Table& table) {
    nb::dict named;
    for (const auto& column : table.columns) named[nb::cast(column.name)] = column.unit;
    return named;
}

void bind_errors(nb::module_& module);
void bind_heights(nb::module_& module);
void bind_surfaces(nb::module_& module);
void bind_loops(nb::module_& module);
void bind_synthesis(nb::module_& module);
void bind_contact(nb::module_& module);
void bind_laboratory(nb::module_& module);
void bind_containers(nb::module_& module);
void bind_studies(nb::module_& module);
void bind_models(nb::module_& module);

}  // namespace setae::python
