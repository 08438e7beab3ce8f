// A program outside the project that links two of its modules.
#include <cmath>
#include <cstdio>

#include <setae/adhesion/work_of_adhesion.hpp>
#include <setae/formats/format.hpp>
#include <setae/roughness/true_area.hpp>

int main() {
    const double ratio = setae::roughness::gaussian_area_ratio(1.46);
    const auto work = setae::adhesion::modified_balance(0.037, 0.025, {ratio, 0.0});
    std::printf("%zu formats, W_app %.2f mJ/m2\n", setae::formats::formats().size(), 1e3 * work.raw);
    return std::abs(1e3 * work.raw - 45.26) < 0.005 ? 0 : 1;
}
