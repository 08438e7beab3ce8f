// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/work_field.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::crack_front {

void require(const WorkField& field) {
    if (field.lines() < 2 || field.points.count < 2 || field.works.cols() != field.points.count)
        throw InvalidArgument(
            fmt::format("a field of {} x {} works for {} points per line; expected 2 or more lines and points, and one "
                        "work per point",
                        field.works.rows(), field.works.cols(), field.points.count));
    if (!(field.points.spacing > 0.0 && field.points.first >= 0.0))
        throw InvalidArgument(fmt::format("points from {} m on, {} m apart; expected 0 or more, increasing",
                                          field.points.first, field.points.spacing));
    if (!(field.mean_work > 0.0 && std::isfinite(field.mean_work)))
        throw InvalidArgument(fmt::format("a mean work of adhesion of {} J/m2; expected more than 0", field.mean_work));
    if (!field.works.isFinite().all()) throw InvalidArgument("some works of the field are not finite");
}

WorkField equivalent_work(const ArrayView2D& stress_intensities, const LinePoints& points, double mean_work,
                          double contact_modulus, EquivalentWork equivalent) {
    if (!(contact_modulus > 0.0))
        throw InvalidArgument(fmt::format("contact modulus {} Pa; expected more than 0", contact_modulus));
    WorkField field{.works = {}, .points = points, .mean_work = mean_work};
    const double toughness = std::sqrt(2.0 * contact_modulus * mean_work);
    field.works = mean_work - toughness / contact_modulus * stress_intensities;
    if (equivalent == EquivalentWork::quadratic) field.works += stress_intensities.square() / (2.0 * contact_modulus);
    require(field);
    return field;
}

WorkField work_of(const std::function<double(double, double)>& work, Index angles, const LinePoints& radii,
                  double mean_work) {
    WorkField field{.works = Array2D(angles, radii.count), .points = radii, .mean_work = mean_work};
    for (Index j = 0; j < angles; ++j)
        for (Index k = 0; k < radii.count; ++k)
            field.works(j, k) = work(radii.at(k), 2.0 * pi * static_cast<double>(j) / static_cast<double>(angles));
    require(field);
    return field;
}

}  // namespace setae::crack_front
