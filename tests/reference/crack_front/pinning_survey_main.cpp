// SPDX-License-Identifier: GPL-3.0-or-later
// pinning_survey [table | short]: the table of docs/validation/crack-front.md, k of straight fronts on both branches
// with
//   its standard error over realisations, against U_el/AW and the front's length; `short`: its small cases
// pinning_survey bands [SEEDS]: fronts through all waves at once and through two bands after each other
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

    void add(double value) {
        sum += value;
        squares += value * value;
        ++count;
    }
    [[nodiscard]] double mean() const { return sum / count; }
    [[nodiscard]] double standard_error() const { return deviation() / std::sqrt(count); }
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

/// A row of the table: a case drawn several times.
struct Row {
    pinning_survey::Case which;
    int seeds = 1;
};

/// Fronts ten times to once as long as their springs let them bend: long ones average by themselves.
std::vector<Row> rows_of_table() {
    std::vector<Row> rows;
    const auto add = [&](double share, setae::Index width, double spring, int seeds) {
        rows.push_back({{.energy_share = share, .way = 512, .width = width, .spring_length = spring}, seeds});
    };
    for (const double spring : {32.0, 64.0, 128.0}) add(0.3, 1024, spring, 2);
    add(0.3, 1024, 256.0, 3);
    add(0.3, 2048, 512.0, 2);
    add(0.3, 2048, 1024.0, 2);
    for (const double spring : {32.0, 64.0}) add(0.1, 1024, spring, 2);
    for (const double share : {0.1, 0.03})
        for (const setae::Index spring : {128, 256, 512})
            for (const setae::Index times : {1, 4, 10})
                add(share, times * spring, static_cast<double>(spring), static_cast<int>(20 / times));
    add(0.1, 2048, 1024.0, 3);
    add(0.1, 2048, 2048.0, 3);
    add(0.1, 4096, 4096.0, 1);
    add(0.03, 2048, 1024.0, 3);
    add(0.03, 4096, 2048.0, 2);
    add(0.03, 4096, 4096.0, 2);
    add(0.01, 2048, 256.0, 3);
    for (const setae::Index spring : {512, 1024})
        for (const setae::Index times : {1, 4})
            add(0.01, times * spring, static_cast<double>(spring), static_cast<int>(12 / times));
    add(0.01, 4096, 2048.0, 2);
    add(0.01, 4096, 4096.0, 2);
    add(0.01, 8192, 8192.0, 1);
    add(0.003, 2048, 512.0, 3);
    add(0.003, 4096, 1024.0, 3);
    add(0.003, 8192, 2048.0, 2);
    add(0.003, 4096, 4096.0, 2);
    add(0.003, 8192, 8192.0, 1);
    add(0.001, 4096, 2048.0, 3);
    add(0.001, 8192, 4096.0, 2);
    // other bands and exponents
    const auto other = [&](double share, setae::Index way, setae::Index width, double spring, double band, double H,
                           int seeds) {
        rows.push_back({{.energy_share = share,
                         .way = way,
                         .width = width,
                         .spring_length = spring,
                         .band = band,
                         .hurst_exponent = H},
                        seeds});
    };
    other(0.1, 512, 2048, 512.0, 4.0, 0.95, 2);
    other(0.1, 512, 2048, 512.0, 4.0, 0.5, 2);
    other(0.1, 256, 2048, 512.0, 2.0, 0.8, 2);
    other(0.1, 1024, 2048, 512.0, 16.0, 0.8, 2);
    other(0.1, 1024, 2048, 512.0, 16.0, 0.5, 2);
    other(0.03, 1024, 4096, 2048.0, 16.0, 0.8, 2);
    other(0.03, 1024, 4096, 2048.0, 16.0, 0.95, 2);
    return rows;
}

void print_table(setae::Index widest) {
    fmt::print(
        "| U_el/AW | band | H | points | front over its free length | free length over the Larkin length N | k on "
        "approach | k on retraction | k | seeds |\n|---|---|---|---|---|---|---|---|---|---|\n");
    for (auto row : rows_of_table()) {
        if (row.which.width > widest) continue;
        Scatter approach, retraction, both, lengths;
        bool converged = true;
        for (int seed = 1; seed <= row.seeds; ++seed) {
            row.which.seed = static_cast<std::uint64_t>(seed);
            const auto result = pinning_survey::run(row.which, 2.0);
            approach.add(-result.approach);
            retraction.add(result.retraction);
            both.add(result.pinning_coefficient);
            lengths.add(result.larkin_lengths);
            converged = converged && result.converged;
        }
        const auto text = [](const Scatter& of) {
            return of.count > 1 ? fmt::format("{:.2f} ± {:.2f}", of.mean(), of.standard_error())
                                : fmt::format("{:.2f}", of.mean());
        };
        fmt::print("| {} | {} | {} | {} x {} | {:.0f} | {:.2f} | {} | {} | {} | {} |{}\n", row.which.energy_share,
                   row.which.band, row.which.hurst_exponent, row.which.way, row.which.width,
                   static_cast<double>(row.which.width) / row.which.spring_length, lengths.mean(), text(approach),
                   text(retraction), text(both), row.seeds, converged ? "" : " not converged");
        std::fflush(stdout);
    }
}

}  // namespace

int main(int count, char** arguments) {
    const std::string_view what = count > 1 ? arguments[1] : "table";
    constexpr setae::Index all = 1 << 30, small = 1024;
    if (what == "bands") print_bands(count > 2 ? std::atoi(arguments[2]) : 3);
    else print_table(what == "short" ? small : all);
}
