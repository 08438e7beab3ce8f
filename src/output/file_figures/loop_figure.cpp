// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/loop_figure.hpp"

#include "axes.hpp"

namespace setae::file_figures {

StudyFigure loop_figure(const study_figures::DrawnLoop& loop, const Look& look) {
    auto drawn = study_figures::loop_figures(loop, look.command).front();
    if (look.wide()) return drawn;
    // the energy release rate repeats what the fits of the first two panels show
    if (drawn.figure.panels.size() > 2) drawn.figure.panels.resize(2);
    drawn.figure.columns = 1;
    drawn.figure.width_mm = column_mm;
    drawn.figure.height_mm = 60.0 * static_cast<double>(drawn.figure.panels.size());
    return drawn;
}

}  // namespace setae::file_figures
