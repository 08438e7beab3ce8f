// SPDX-License-Identifier: GPL-3.0-or-later
// Apparent work along the edge of simulated round contacts: tests/reference/crack_front/README.md has the commands.
#pragma once

namespace round_contacts {

constexpr double radius = 1e-3, contact_modulus = 0.75e6;  ///< R [m], E* [Pa]
constexpr double work_of_adhesion = 0.05;                  ///< W that went in [J/m²]

/// Mean over the steps of a branch whose radius √(A/π) is in a range of 10 µm.
struct EdgeWork {
    double energy_share;  ///< U_el/(A W)
    int seed;             ///< of the surface
    bool approach;
    double contact_radius;  ///< middle of the range [m]
    double larkin_lengths;  ///< N at the mean radius
    int steps;
    double work;  ///< G = E*(δ − a²/R)²/(2πa) [J/m²]
};

constexpr EdgeWork edge_works[] = {
    {0.1001, 1, true, 75e-6, 6.52, 143, 42.051e-3},  {0.1001, 1, true, 85e-6, 5.85, 139, 41.974e-3},
    {0.1001, 1, true, 95e-6, 5.33, 193, 43.106e-3},  {0.1001, 1, false, 45e-6, 13.62, 60, 58.628e-3},
    {0.1001, 1, false, 55e-6, 9.26, 76, 58.651e-3},  {0.1001, 1, false, 65e-6, 7.66, 100, 57.438e-3},
    {0.1001, 1, false, 75e-6, 6.58, 121, 58.281e-3}, {0.1001, 1, false, 85e-6, 5.89, 161, 57.215e-3},
    {0.1001, 1, false, 95e-6, 5.46, 106, 56.396e-3}, {0.1001, 2, true, 75e-6, 6.58, 116, 42.569e-3},
    {0.1001, 2, true, 85e-6, 5.87, 175, 42.645e-3},  {0.1001, 2, true, 95e-6, 5.32, 183, 43.098e-3},
    {0.1001, 2, false, 45e-6, 13.35, 63, 59.171e-3}, {0.1001, 2, false, 55e-6, 9.48, 70, 57.757e-3},
    {0.1001, 2, false, 65e-6, 7.69, 106, 57.396e-3}, {0.1001, 2, false, 75e-6, 6.60, 132, 56.789e-3},
    {0.1001, 2, false, 85e-6, 5.85, 153, 57.564e-3}, {0.1001, 2, false, 95e-6, 5.45, 104, 56.418e-3},
    {0.1001, 3, true, 75e-6, 6.55, 124, 42.795e-3},  {0.1001, 3, true, 85e-6, 5.87, 159, 42.714e-3},
    {0.1001, 3, true, 95e-6, 5.35, 175, 42.818e-3},  {0.1001, 3, false, 45e-6, 13.19, 51, 58.798e-3},
    {0.1001, 3, false, 55e-6, 9.52, 74, 57.745e-3},  {0.1001, 3, false, 65e-6, 7.62, 108, 57.936e-3},
    {0.1001, 3, false, 75e-6, 6.58, 121, 57.514e-3}, {0.1001, 3, false, 85e-6, 5.86, 171, 56.967e-3},
    {0.1001, 3, false, 95e-6, 5.40, 121, 56.356e-3}, {0.0300, 1, true, 75e-6, 4.85, 91, 47.104e-3},
    {0.0300, 1, true, 85e-6, 4.41, 152, 47.195e-3},  {0.0300, 1, true, 95e-6, 4.01, 190, 47.234e-3},
    {0.0300, 1, false, 45e-6, 9.94, 46, 53.607e-3},  {0.0300, 1, false, 55e-6, 7.21, 73, 53.156e-3},
    {0.0300, 1, false, 65e-6, 5.78, 109, 53.043e-3}, {0.0300, 1, false, 75e-6, 4.95, 128, 52.945e-3},
    {0.0300, 1, false, 85e-6, 4.40, 166, 52.809e-3}, {0.0300, 1, false, 95e-6, 4.04, 139, 52.620e-3},
    {0.0300, 2, true, 75e-6, 4.84, 94, 47.131e-3},   {0.0300, 2, true, 85e-6, 4.39, 156, 47.205e-3},
    {0.0300, 2, true, 95e-6, 4.00, 184, 47.330e-3},  {0.0300, 2, false, 45e-6, 10.20, 54, 53.354e-3},
    {0.0300, 2, false, 55e-6, 7.13, 73, 53.214e-3},  {0.0300, 2, false, 65e-6, 5.79, 104, 52.850e-3},
    {0.0300, 2, false, 75e-6, 4.96, 131, 52.802e-3}, {0.0300, 2, false, 85e-6, 4.40, 159, 52.913e-3},
    {0.0300, 2, false, 95e-6, 4.03, 159, 52.631e-3}, {0.0300, 3, true, 75e-6, 4.84, 91, 47.184e-3},
    {0.0300, 3, true, 85e-6, 4.40, 154, 47.307e-3},  {0.0300, 3, true, 95e-6, 4.01, 190, 47.345e-3},
    {0.0300, 3, false, 45e-6, 10.14, 51, 53.322e-3}, {0.0300, 3, false, 55e-6, 7.16, 73, 53.172e-3},
    {0.0300, 3, false, 65e-6, 5.77, 106, 53.266e-3}, {0.0300, 3, false, 75e-6, 4.96, 130, 52.835e-3},
    {0.0300, 3, false, 85e-6, 4.40, 161, 52.721e-3}, {0.0300, 3, false, 95e-6, 4.04, 147, 52.633e-3},
};

/// What `contact front` prints of each loop, with E* fitted to the approach.
struct FittedWorks {
    double energy_share;
    int seed;
    double larkin_length;                     ///< L_c [m]
    double work_approach, work_retraction;    ///< [J/m²]
    double known_approach, known_retraction;  ///< with the known E*, mean over the moving edge [J/m²]
    double pull_off_force;                    ///< [N]
};

constexpr FittedWorks fitted_works[] = {{0.1001, 1, 11.833e-6, 42.060e-3, 54.400e-3, 42.250e-3, 57.739e-3, 277.59e-6},
                                        {0.1001, 2, 11.833e-6, 42.372e-3, 54.133e-3, 42.795e-3, 57.354e-3, 281.67e-6},
                                        {0.1001, 3, 11.833e-6, 42.605e-3, 54.882e-3, 42.752e-3, 57.487e-3, 283.99e-6},
                                        {0.0300, 1, 15.779e-6, 47.062e-3, 52.312e-3, 47.196e-3, 52.936e-3, 253.06e-6},
                                        {0.0300, 2, 15.779e-6, 46.925e-3, 52.089e-3, 47.245e-3, 52.914e-3, 253.26e-6},
                                        {0.0300, 3, 15.779e-6, 47.165e-3, 52.282e-3, 47.297e-3, 52.911e-3, 254.03e-6}};

}  // namespace round_contacts
