// SPDX-License-Identifier: GPL-3.0-or-later
// pinning_survey [SEEDS] [bands]: the tables of docs/measured/crack-front.md, k of straight fronts with its scatter
// over realisations; with `bands`, of fronts through all waves at once and through two bands after each other.
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "pinning_survey.hpp"

namespace {

/// Mean and standard deviation over realisations.
struct Scatter {
    double sum = 0.0, squares = 0.0;
    int count = 0;

    void add(double value) { sum += value, squares += value * value, ++count; }
    [[nodiscard]] double mean() const { return sum / count; }
    [[nodiscard]] double deviation() const {
        return count > 1 ? std::sqrt(std::max(squares - sum * sum / count, 0.0) / (count - 1)) : 0.0;
    }
};

void print_bands(int seeds) {
    const std::vector<pinning_survey::Case> cases = {{.energy_share = 0.1, .way = 1024, .width = 2048, .band = 16.0},
                                                     {.energy_share = 0.1, .way = 512, .width = 2048, .band = 4.0},
                                                     {.energy_share = 0.03, .way = 1024, .width = 4096, .band = 16.0},
                                                     {.energy_share = 0.03, .way = 512, .width = 4096, .band = 4.0}};
    fmt::print(
        "| U_el/AW | points | band | U_el in the finer half | k of all waves, ± sd of {} | k of the bands | ratio |\n"
        "|---|---|---|---|---|---|---|\n",
        seeds);
    for (auto which : cases) {
        Scatter together, apart, ratio, share;
        bool converged = true;
        for (int seed = 1; seed <= seeds; ++seed) {
            which.seed = static_cast<std::uint64_t>(seed);
            const auto result = pinning_survey::run_in_bands(which, 2.0);
            together.add(result.together.pinning_coefficient);
            apart.add(result.apart.pinning_coefficient);
            ratio.add(result.apart.pinning_coefficient / result.together.pinning_coefficient);
            share.add(result.fine_share);
            converged = converged && result.together.converged && result.apart.converged;
        }
        fmt::print("| {} | {} x {} | {} | {:.2f} | {:.2f} ± {:.2f} | {:.2f} ± {:.2f} | {:.2f} ± {:.2f} |{}\n",
                   which.energy_share, which.way, which.width, which.band, share.mean(), together.mean(),
                   together.deviation(), apart.mean(), apart.deviation(), ratio.mean(), ratio.deviation(),
                   converged ? "" : " not converged");
        std::fflush(stdout);
    }
}

}  // namespace

int main(int count, char** arguments) {
    const int seeds = count > 1 ? std::atoi(arguments[1]) : 3;
    if (count > 2 && std::string_view(arguments[2]) == "bands") {
        print_bands(seeds);
        return 0;
    }
    const std::vector<pinning_survey::Case> cases = {
        {.energy_share = 0.3, .way = 512, .width = 2048},
        {.energy_share = 0.1, .way = 512, .width = 128},
        {.energy_share = 0.1, .way = 512, .width = 2048},
        {.energy_share = 0.03, .way = 512, .width = 256},
        {.energy_share = 0.03, .way = 512, .width = 1024},
        {.energy_share = 0.03, .way = 512, .width = 4096},
        {.energy_share = 0.03, .way = 1024, .width = 4096, .band = 16.0},
        {.energy_share = 0.03, .way = 1024, .width = 4096, .band = 16.0, .hurst_exponent = 0.5},
        {.energy_share = 0.01, .way = 512, .width = 8192}};
    fmt::print(
        "| U_el/AW | points | band | H | front over its Larkin length | k, mean ± sd of {} | (W_appr − W)/U | "
        "(W_ret − W)/U |\n|---|---|---|---|---|---|---|---|\n",
        seeds);
    for (auto which : cases) {
        double sum = 0.0, squares = 0.0, approach = 0.0, retraction = 0.0, lengths = 0.0;
        bool converged = true;
        for (int seed = 1; seed <= seeds; ++seed) {
            which.seed = static_cast<std::uint64_t>(seed);
            const auto result = pinning_survey::run(which, 2.0);
            sum += result.pinning_coefficient / seeds;
            squares += result.pinning_coefficient * result.pinning_coefficient / seeds;
            approach += result.approach / seeds;
            retraction += result.retraction / seeds;
            lengths += result.larkin_lengths / seeds;
            converged = converged && result.converged;
        }
        const double deviation = seeds > 1 ? std::sqrt(std::max(squares - sum * sum, 0.0) * seeds / (seeds - 1)) : 0.0;
        fmt::print("| {} | {} x {} | {} | {} | {:.1f} | {:.2f} ± {:.2f} | {:.2f} | {:.2f} |{}\n", which.energy_share,
                   which.way, which.width, which.band, which.hurst_exponent, lengths, sum, deviation, approach,
                   retraction, converged ? "" : " not converged");
        std::fflush(stdout);
    }
}
