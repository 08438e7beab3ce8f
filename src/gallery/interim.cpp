// SPDX-License-Identifier: GPL-3.0-or-later
#include "builders.hpp"

namespace setae::gallery {
#define INTERIM(name) void name(const Sitting&, StudyFigure& drawn) { drawn.reason = "it is in preparation"; }
INTERIM(combined_spectra) INTERIM(contact_of_one_elastomer) INTERIM(prediction_and_loss) INTERIM(stylus_scans) INTERIM(spectra_by_instrument)
INTERIM(isotropic_spectra) INTERIM(contact_radius_of_all) INTERIM(contact_radius_of_references) INTERIM(true_area)
INTERIM(persson_tosatti_prediction) INTERIM(scales_of_cost) INTERIM(agreement_of_instruments)
void measured_spectra(const Sitting&, const workflow::SurfaceResult&, StudyFigure& drawn) { drawn.reason = "it is in preparation"; }
}  // namespace setae::gallery
