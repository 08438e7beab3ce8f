// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::python {

/// Heights in memory of setae or in an array of NumPy, which is not copied.
class Heights {
public:
    explicit Heights(topography::Measurement measurement);
    /// array: a NumPy array in metres, C-contiguous, with one or two dimensions, x first.
    Heights(nb::object array, const std::vector<double>& size, bool periodic, const std::string& name);

    /// The given array of NumPy, or an array that uses the memory of setae.
    [[nodiscard]] nb::object array(nb::handle self) const;
    /// Positions of a traced curve; None for heights on a grid.
    [[nodiscard]] nb::object positions(nb::handle self) const;
    [[nodiscard]] std::vector<double> size() const;
    [[nodiscard]] bool periodic() const;
    [[nodiscard]] Index points() const;
    [[nodiscard]] const topography::Metadata& metadata() const;
    /// A copy; needs no lock of the interpreter.
    [[nodiscard]] topography::Measurement measurement() const;

private:
    std::shared_ptr<topography::Measurement> own_;  ///< for an array: the measurement without its heights
    std::shared_ptr<nb::object> given_;
    const double* data_ = nullptr;
    std::array<Index, 2> shape_{};
};

/// A measurement of Python: a file or heights in memory, and its processing.
struct Item {
    std::string path;  ///< path of a file, or name of heights in memory
    std::shared_ptr<Heights> heights;
    answers::SurfaceRequest request;
};

/// True for one measurement in memory whose spectrum takes at most a millisecond.
[[nodiscard]] bool are_few_heights(const std::vector<std::shared_ptr<Item>>& items);

/// One surface from the items. @throws InvalidArgument as SurfaceRequest.
[[nodiscard]] study::SurfaceInput surface_of(const std::vector<std::shared_ptr<Item>>& items);

/// The measurements of one item after its steps. @throws errors of reading and of the steps.
[[nodiscard]] std::vector<topography::Measurement> measurements_of(const Item& item);

/// The first measurement of an item, with the record of its steps. @throws errors of reading and of the steps.
[[nodiscard]] processing::PipelineResult prepared_of(const Item& item);

/// @throws InvalidArgument with the reason if a surface has no result.
[[nodiscard]] const study::SurfaceResult& analysed(const study::SurfaceResult& surface);

}  // namespace setae::python
