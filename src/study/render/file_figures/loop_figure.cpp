// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/loop_figure.hpp"

namespace setae::file_figures {

StudyFigure loop_figure(const study_figures::DrawnLoop& loop, const Look& look) {
    return study_figures::loop_figures(loop, look.command, look.width).front();
}

}  // namespace setae::file_figures
