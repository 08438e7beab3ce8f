// SPDX-License-Identifier: GPL-3.0-or-later
#include "layout.hpp"

namespace setae::figures {

double legend_strip_mm(const Figure& figure, std::size_t panel) {
    const auto size = legend_size(figure.panels[panel]);
    return size.entries == 0 ? 0.0 : LegendSize::height_mm(size.rows_within(figure.width_mm));
}

void put_legend_above(Figure& figure, std::size_t panel) {
    const double strip = legend_strip_mm(figure, panel) / figure.height_mm;
    if (strip == 0.0) return;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        auto place = place_of(figure, p);
        place.top = strip + (1.0 - strip) * place.top;
        place.height *= 1.0 - strip;
        figure.panels[p].place = place;
    }
    figure.panels[panel].legend_right = false;
    figure.panels[panel].legend_place = Place{0.0, 0.0, 1.0, strip};
}

}  // namespace setae::figures
