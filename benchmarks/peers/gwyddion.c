/* SPDX-License-Identifier: GPL-3.0-or-later
   Times one task of Gwyddion's C library (Debian: libgwyddion20-dev libgtkglext1-dev), the best of several runs:

       gcc -O2 gwyddion.c -o gwyddion $(pkg-config --cflags --libs gwyddion) -lm && ./gwyddion TASK MAP.npy POINTS [REPEAT]

   MAP.npy: float64, POINTS x POINTS over 1 m x 1 m; NaN is undefined. Writes {"seconds": …, "values": [...]}. */
#include <libprocess/correct.h>
#include <libprocess/filters.h>
#include <libprocess/gwyprocess.h>
#include <libprocess/level.h>
#include <libprocess/stats.h>
#include <libprocess/tip.h>
#include <libgwyddion/gwythreads.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* A paraboloid of 41 x 41 pixels, as high as the rms height 20 pixels from its apex; Gwyddion's tips point up. */
static GwyDataField* paraboloid(GwyDataField* map) {
    const double pixel = gwy_data_field_get_dx(map), z = gwy_data_field_get_rms(map);
    GwyDataField* tip = gwy_data_field_new(41, 41, 41 * pixel, 41 * pixel, TRUE);
    double* t = gwy_data_field_get_data(tip);
    for (int i = 0; i < 41; i++)
        for (int j = 0; j < 41; j++) t[i * 41 + j] = -z * ((i - 20) * (i - 20) + (j - 20) * (j - 20)) / 400.0;
    gwy_data_field_add(tip, -gwy_data_field_get_min(tip));
    return tip;
}

int main(int argc, char** argv) {
    if (argc < 4) return 2;
    const char* task = argv[1];
    const int points = atoi(argv[3]), repeat = argc > 4 ? atoi(argv[4]) : 5;
    const size_t count = (size_t)points * (size_t)points;
    gwy_process_type_init();
    gwy_threads_set_enabled(TRUE);
    FILE* file = fopen(argv[2], "rb");
    GwyDataField* map = gwy_data_field_new(points, points, 1.0, 1.0, FALSE);
    GwyDataField* holes = gwy_data_field_new_alike(map, TRUE);
    double* h = gwy_data_field_get_data(map);
    if (!file || fseek(file, 128, SEEK_SET) != 0 || fread(h, sizeof(double), count, file) != count) return 1;
    for (size_t k = 0; k < count; k++)
        if (isnan(h[k])) h[k] = 0.0, gwy_data_field_get_data(holes)[k] = 1.0;
    GwyDataField *tip = paraboloid(map), *result = gwy_data_field_new_alike(map, TRUE);
    GwyDataLine* line = gwy_data_line_new(1, 1.0, FALSE);
    const GwyInterpolationType linear = GWY_INTERPOLATION_LINEAR;
    double best = HUGE_VAL, values[3] = {0.0, 0.0, 0.0};
    int kept = 0;
    for (int run = 0; run < repeat; run++) {
        gwy_data_field_invalidate(map);
        const double begin = now();
        if (!strcmp(task, "psd_lines"))
            gwy_data_field_psdf(map, line, GWY_ORIENTATION_HORIZONTAL, linear, GWY_WINDOWING_HANN, -1);
        else if (!strcmp(task, "psd_area")) gwy_data_field_rpsdf(map, line, linear, GWY_WINDOWING_HANN, -1);
        else if (!strcmp(task, "acf_lines")) gwy_data_field_acf(map, line, GWY_ORIENTATION_HORIZONTAL, linear, -1);
        else if (!strcmp(task, "acf_area"))
            gwy_data_field_area_2dacf(map, result, 0, 0, points, points, points / 2 - 1, points / 2 - 1);
        else if (!strcmp(task, "moments")) {
            double mean, rms, skewness, kurtosis;
            gwy_data_field_get_stats(map, &mean, &values[0], &rms, &skewness, &kurtosis);
            values[1] = rms, values[2] = skewness, kept = 3;
        } else if (!strcmp(task, "true_area")) {
            volatile double area = gwy_data_field_get_surface_area(map);
            (void)area;
        } else if (!strcmp(task, "background")) {
            GwyDataField* level = gwy_data_field_duplicate(map);
            double* coefficients = gwy_data_field_fit_polynom(level, 3, 3, NULL);
            gwy_data_field_subtract_polynom(level, 3, 3, coefficients);
            g_free(coefficients);
            g_object_unref(level);
        } else if (!strcmp(task, "gaussian")) {
            GwyDataField* smooth = gwy_data_field_duplicate(map);
            gwy_data_field_filter_gaussian(smooth, 20.0);
            g_object_unref(smooth);
        } else if (!strcmp(task, "fill")) {
            GwyDataField* whole = gwy_data_field_duplicate(map);
            gwy_data_field_laplace_solve(whole, holes, -1, 2.0);
            g_object_unref(whole);
        } else if (!strcmp(task, "dilation")) gwy_tip_dilation(tip, map, result, NULL, NULL);
        else return 2;
        const double seconds = now() - begin;
        if (seconds < best) best = seconds;
    }
    printf("{\"seconds\": %.9g, \"values\": [", best);
    for (int k = 0; k < kept; k++) printf("%s%.17g", k ? ", " : "", values[k]);
    printf("]}\n");
    return 0;
}
