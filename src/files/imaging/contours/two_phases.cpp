// SPDX-License-Identifier: GPL-3.0-or-later
#include "two_phases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Cholesky>

#include "phase_cut.hpp"
#include "setae/core/statistics.hpp"

namespace setae::imaging {
namespace {

using Map = CellMap;

constexpr long coarse_cells = 48;    // across the shorter side, where levels are found
constexpr double border_cost = 2.0;  // of a side of a square, in units of ln likelihood
constexpr double max_cost =
    8.0;  // limit for a level or structure far from both phases: squares on the border, glare and dust
constexpr double min_phase_share =
    1e-3;  // of the range of levels: smaller scatter is rounding and the tails of blur, not structure
constexpr double least_squares_of_a_phase = 20;
constexpr int first_turns = 2, max_turns = 10;  // alternating cuts and levels: for every start, and for the best ones
constexpr std::size_t best_starts = 3;
constexpr double min_noise_ratio = 1.3;  // ratio of noise that distinguishes the phases
constexpr long max_samples = 1'000'000;  // of pixels for a median
constexpr long band = 3;                 // squares on either side of a border for a repeated cut

/// 1, x, y, x², xy, y² of the illumination, then 1, x, y of the sample on it; x, y in −1 … 1.
constexpr int terms = 9;
using Terms = Eigen::Matrix<double, terms, 1>;

Terms terms_at(double x, double y, bool sample) {
    Terms t;
    t << 1, x, y, x * x, x * y, y * y, sample ? 1 : 0, sample ? x : 0, sample ? y : 0;
    return t;
}

struct PhaseModel {
    Terms levels = Terms::Zero();
    std::array<double, 2> scatter{1, 1}, structure{0, 0}, structure_scatter{1, 1};  ///< vacuum, sample as labelled
};

double place(long i, long n) { return n > 1 ? 2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1.0 : 0.0; }

/// Levels and scatter of a division, by squares away from its border, if there are some of both; false if a phase has
/// too few.
bool fit(PhaseModel& model, const Cells& cells, const PixelMask& labels, double min_scatter,
         double min_structure_scatter) {
    const long rows = labels.rows(), columns = labels.cols();
    const CellMap weight = cells.weight * away_from_border(labels, 1).cast<double>();
    std::array<double, 2> count{};
    Eigen::Matrix<double, terms, terms> normal = Eigen::Matrix<double, terms, terms>::Zero();
    Terms right = Terms::Zero();
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column) {
            if (weight(row, column) == 0) continue;
            const int label = labels(row, column);
            const double certainty = 1.0 / (model.scatter[label] * model.scatter[label]);
            const Terms t = terms_at(place(column, columns), place(row, rows), label == 1);
            normal.noalias() += certainty * t * t.transpose();
            right += certainty * cells.mean(row, column) * t;
            count[label] += 1;
        }
    if (std::min(count[0], count[1]) < least_squares_of_a_phase) return false;
    normal.diagonal().array() += 1e-9 * normal.trace();
    model.levels = normal.ldlt().solve(right);
    std::array<double, 2> squares{}, sum{}, structure_squares{};
    for (int pass = 0; pass < 2; ++pass)
        for (long row = 0; row < rows; ++row)
            for (long column = 0; column < columns; ++column) {
                if (weight(row, column) == 0) continue;
                const int label = labels(row, column);
                if (pass == 0) {
                    const double residual =
                        cells.mean(row, column) -
                        model.levels.dot(terms_at(place(column, columns), place(row, rows), label == 1));
                    squares[label] += residual * residual;
                    sum[label] += cells.log_variance(row, column);
                } else {
                    const double residual = cells.log_variance(row, column) - sum[label] / count[label];
                    structure_squares[label] += residual * residual;
                }
            }
    for (int label : {0, 1}) {
        model.scatter[label] = std::max(min_scatter, std::sqrt(squares[label] / count[label]));
        model.structure[label] = sum[label] / count[label];
        model.structure_scatter[label] =
            std::max(min_structure_scatter, std::sqrt(structure_squares[label] / count[label]));
    }
    return true;
}

double cost(const PhaseModel& model, const Cells& cells, long row, long column, int label, const Terms& t) {
    const double level = (cells.mean(row, column) - model.levels.dot(t)) / model.scatter[label];
    const double structure =
        (cells.log_variance(row, column) - model.structure[label]) / model.structure_scatter[label];
    return std::min(0.5 * level * level, max_cost) + std::log(model.scatter[label]) +
           std::min(0.5 * structure * structure, max_cost) + std::log(model.structure_scatter[label]);
}

/// Preference of vacuum over sample; and the energy of the given division.
struct Preference {
    Map difference;
    double energy = 0;
};

Preference preference(const PhaseModel& model, const Cells& cells, const PixelMask& labels) {
    const long rows = labels.rows(), columns = labels.cols();
    Preference found{Map::Zero(rows, columns), 0};
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column) {
            if (cells.weight(row, column) == 0) continue;
            const double x = place(column, columns), y = place(row, rows);
            const double vacuum = cost(model, cells, row, column, 0, terms_at(x, y, false)),
                         sample = cost(model, cells, row, column, 1, terms_at(x, y, true));
            found.difference(row, column) = sample - vacuum;
            found.energy += labels(row, column) == 1 ? sample : vacuum;
        }
    return found;
}

double border(const PixelMask& labels) {
    double length = 0;
    for (long row = 0; row < labels.rows(); ++row)
        for (long column = 0; column < labels.cols(); ++column) {
            if (column + 1 < labels.cols() && labels(row, column) != labels(row, column + 1)) length += 1;
            if (row + 1 < labels.rows() && labels(row, column) != labels(row + 1, column)) length += 1;
        }
    return length;
}

PixelMask above(const Map& map, double level) { return (map > level).cast<std::uint8_t>(); }

/// Otsu's level: largest variance between the two parts.
double otsu(const Map& map, const Map& weight) {
    std::vector<double> values;
    for (long i = 0; i < map.size(); ++i)
        if (weight.data()[i] > 0) values.push_back(map.data()[i]);
    std::sort(values.begin(), values.end());
    double total = 0, below = 0, best = -1, level = values.front();
    for (const double v : values) total += v;
    const double n = static_cast<double>(values.size());
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        below += values[i];
        const double count = static_cast<double>(i + 1), difference = below / count - (total - below) / (n - count);
        const double between = count * (n - count) * difference * difference;
        if (between > best) {
            best = between;
            level = 0.5 * (values[i] + values[i + 1]);
        }
    }
    return level;
}

std::vector<PixelMask> starts(const Cells& cells) {
    const long rows = cells.mean.rows(), columns = cells.mean.cols();
    std::vector<PixelMask> list{above(-cells.mean, -otsu(cells.mean, cells.weight)),
                                above(cells.log_variance, otsu(cells.log_variance, cells.weight))};
    constexpr double pi = 3.14159265358979323846;
    for (int direction = 0; direction < 8; ++direction)
        for (const double offset : {-0.4, 0.0, 0.4}) {
            if (offset < 0 && direction % 2 == 1) continue;
            PixelMask half(rows, columns);
            const double angle = pi * direction / 8;
            for (long row = 0; row < rows; ++row)
                for (long column = 0; column < columns; ++column)
                    half(row, column) =
                        std::cos(angle) * place(column, columns) + std::sin(angle) * place(row, rows) > offset ? 1 : 0;
            list.push_back(half);
        }
    return list;
}

struct Division {
    PixelMask labels;
    PhaseModel model;
    double energy = std::numeric_limits<double>::infinity();
};

struct LeastScatter {
    double level, structure;
};

Division settled(const Cells& cells, PixelMask labels, const LeastScatter& least, int turns) {
    Division best;
    PhaseModel model;
    model.scatter = {1, 1};
    for (int turn = 0; turn < turns; ++turn) {
        if (!fit(model, cells, labels, least.level, least.structure)) break;
        const auto wish = preference(model, cells, labels);
        const double energy = wish.energy + border_cost * border(labels);
        if (energy < best.energy) best = {labels, model, energy};
        const auto next =
            minimum_cut(wish.difference, border_cost, PixelMask::Ones(labels.rows(), labels.cols()), labels);
        if ((next == labels).all()) break;
        labels = next;
    }
    return best;
}

Division best_division(const Cells& cells, const LeastScatter& least) {
    std::vector<Division> tried;
    for (auto& start : starts(cells)) tried.push_back(settled(cells, std::move(start), least, first_turns));
    std::stable_sort(tried.begin(), tried.end(), [](const auto& a, const auto& b) { return a.energy < b.energy; });
    Division best;
    for (std::size_t i = 0; i < std::min(best_starts, tried.size()); ++i) {
        if (tried[i].labels.size() == 0) continue;
        auto found = settled(cells, std::move(tried[i].labels), least, max_turns);
        if (found.energy < best.energy) best = std::move(found);
    }
    return best;
}

/// The energy of a single phase with a quadratic level.
double undivided_energy(const Cells& cells, const LeastScatter& least) {
    const long rows = cells.mean.rows(), columns = cells.mean.cols();
    using Six = Eigen::Matrix<double, 6, 1>;
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Six right = Six::Zero();
    double count = 0, structure = 0;
    const auto quadratic = [&](long row, long column) {
        return Six(terms_at(place(column, columns), place(row, rows), false).head<6>());
    };
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column) {
            if (cells.weight(row, column) == 0) continue;
            const Six t = quadratic(row, column);
            normal += t * t.transpose();
            right += cells.mean(row, column) * t;
            structure += cells.log_variance(row, column);
            count += 1;
        }
    const Six levels = normal.ldlt().solve(right);
    double squares = 0, structure_squares = 0;
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column) {
            if (cells.weight(row, column) == 0) continue;
            const double residual = cells.mean(row, column) - levels.dot(quadratic(row, column)),
                         other = cells.log_variance(row, column) - structure / count;
            squares += residual * residual;
            structure_squares += other * other;
        }
    const double scatter = std::max(least.level, std::sqrt(squares / count)),
                 structure_scatter = std::max(least.structure, std::sqrt(structure_squares / count));
    return count * (std::log(scatter) + std::log(structure_scatter)) + 0.5 * squares / (scatter * scatter) +
           0.5 * structure_squares / (structure_scatter * structure_scatter);
}

PixelMask enlarged(const PixelMask& labels, long rows, long columns, long ratio) {
    PixelMask larger(rows, columns);
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column)
            larger(row, column) =
                labels(std::min(row / ratio, labels.rows() - 1), std::min(column / ratio, labels.cols() - 1));
    return larger;
}

/// Levels and noise away from the border, and the phase of vacuum: that with less structure, the brighter one if
/// similar.
void name_phases(TwoPhases& result, const FramePixels& pixels, const PixelMask& hidden, const PhaseModel& model,
                 long side, Vacuum vacuum) {
    std::array<std::vector<double>, 2> levels;
    const auto inner = away_from_border(result.sample, std::max(4L, side / 2));
    const long stride = std::max(1L, pixels.size() / max_samples);
    for (long i = 0; i < pixels.size(); i += stride)
        if (inner.data()[i] != 0 && hidden.data()[i] == 0)
            levels[result.sample.data()[i]].push_back(static_cast<double>(pixels.data()[i]));
    std::array<double, 2> level{}, noise{};
    for (int label : {0, 1}) {
        if (levels[label].empty()) continue;
        level[label] = upper_median(std::move(levels[label]));
        noise[label] = side > 1 ? std::exp(0.5 * model.structure[label]) : model.scatter[label];
    }
    const double ratio = noise[1] > 0 && noise[0] > 0 ? noise[1] / noise[0] : 1.0;
    const bool structured = ratio > min_noise_ratio || ratio < 1 / min_noise_ratio;
    bool swap = structured ? ratio < 1 : level[0] < level[1];
    result.vacuum_assumed = vacuum == Vacuum::automatic && !structured;
    if (vacuum == Vacuum::bright) swap = level[0] < level[1];
    if (vacuum == Vacuum::dark) swap = level[0] > level[1];
    if (swap) {
        result.sample = 1 - result.sample;
        std::swap(level[0], level[1]);
        std::swap(noise[0], noise[1]);
    }
    result.vacuum_level = level[0];
    result.sample_level = level[1];
    result.vacuum_noise = noise[0];
    result.sample_noise = noise[1];
    result.vacuum = level[0] >= level[1] ? Vacuum::bright : Vacuum::dark;
}

}  // namespace

TwoPhases divide(const FramePixels& pixels, const PixelMask& hidden, Vacuum vacuum) {
    long side = 1;
    while (std::min(pixels.rows(), pixels.cols()) / (2 * side) >= coarse_cells) side *= 2;
    auto coarse = cells_of(pixels, hidden, side, 0, 0, pixels.rows() / side, pixels.cols() / side);
    const double min_level = std::max(std::numeric_limits<double>::min(),
                                      min_phase_share * (coarse.mean.maxCoeff() - coarse.mean.minCoeff()));
    coarse.log_variance = coarse.log_variance.max(2 * std::log(min_level));
    const LeastScatter least{min_level, side > 1 ? 0.7 * std::sqrt(2.0 / static_cast<double>(side * side - 1)) : 1.0};
    const auto best = best_division(coarse, least);
    TwoPhases result;
    result.cells = static_cast<double>(coarse.mean.size());
    if (best.labels.size() == 0) return result;
    result.gain = undivided_energy(coarse, least) - best.energy;

    auto labels = best.labels;
    for (long finer = side / 2; finer >= 1; finer /= 2) {
        labels = enlarged(labels, pixels.rows() / finer, pixels.cols() / finer, 2);
        labels = cut_in_band(pixels, hidden, finer, labels, band, border_cost);
    }
    result.sample = labels.rows() == pixels.rows() && labels.cols() == pixels.cols()
                        ? labels
                        : enlarged(labels, pixels.rows(), pixels.cols(), 1);

    name_phases(result, pixels, hidden, best.model, side, vacuum);
    return result;
}

TwoPhases divide_binary(const FramePixels& pixels, const PixelMask& hidden, Vacuum vacuum) {
    const float low = pixels.minCoeff(), high = pixels.maxCoeff();
    const PixelMask bright = (pixels == high && hidden == 0).cast<std::uint8_t>();
    const long rows = pixels.rows(), columns = pixels.cols();
    const long rim = 2 * (rows + columns);
    const long bright_rim = (bright.row(0) != 0).count() + (bright.row(rows - 1) != 0).count() +
                            (bright.col(0) != 0).count() + (bright.col(columns - 1) != 0).count();
    TwoPhases result;
    const bool vacuum_bright = vacuum == Vacuum::automatic ? 2 * bright_rim > rim : vacuum == Vacuum::bright;
    result.sample = vacuum_bright ? PixelMask(1 - bright) : bright;
    result.vacuum = vacuum_bright ? Vacuum::bright : Vacuum::dark;
    result.vacuum_level = static_cast<double>(vacuum_bright ? high : low);
    result.sample_level = static_cast<double>(vacuum_bright ? low : high);
    return result;
}

}  // namespace setae::imaging
