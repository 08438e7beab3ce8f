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

/// Heights in memory: setae's own or an array of NumPy, which is not copied.
class Heights {
public:
    explicit Heights(topography::Measurement measurement);
    /// array: of NumPy, C-contiguous, in metres, of one dimension or two; x first.
    Heights(nb::object array, const std::vector<double>& size, bool periodic, const std::string& name);

    /// The array of NumPy that was given, or one on setae's memory.
    [[nodiscard]] nb::object array(nb::handle self) const;
    /// Of a traced curve; None of what lies on a grid.
    [[nodiscard]] nb::object positions(nb::handle self) const;
    [[nodiscard]] std::vector<double> size() const;
    [[nodiscard]] bool periodic() const;
    [[nodiscard]] Index points() const;
    [[nodiscard]] const topography::Metadata& metadata() const;
    /// A copy; works without the interpreter's lock.
    [[nodiscard]] topography::Measurement measurement() const;

private:
    std::shared_ptr<topography::Measurement> own_;  ///< of an array: what it is but for its heights
    std::shared_ptr<nb::object> given_;
    const double* data_ = nullptr;
    std::array<Index, 2> shape_{};
};

/// A measurement as Python names it: a file or heights in memory, and how it is prepared.
struct Item {
    std::string path;  ///< of a file; of heights what they are called
    std::shared_ptr<Heights> heights;
    answers::SurfaceRequest request;
};

/// Whether they are one measurement in memory, of so few heights that its spectrum takes a millisecond or less.
[[nodiscard]] bool are_few_heights(const std::vector<std::shared_ptr<Item>>& items);

/// One surface of them. @throws InvalidArgument as SurfaceRequest does.
[[nodiscard]] study::SurfaceInput surface_of(const std::vector<std::shared_ptr<Item>>& items);

/// The measurements of one, behind its steps. @throws what reading and the steps throw.
[[nodiscard]] std::vector<topography::Measurement> measurements_of(const Item& item);

/// The first of them, and what its steps did. @throws likewise.
[[nodiscard]] processing::PipelineResult prepared_of(const Item& item);

/// @throws InvalidArgument that says why a surface gave nothing.
[[nodiscard]] const study::SurfaceResult& analysed(const study::SurfaceResult& surface);

}  // namespace setae::python
