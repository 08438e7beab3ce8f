// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/traced_value.hpp"
#include "setae/study/study_result.hpp"

namespace setae::output {

/// A reported number, with the contributions to its standard error.
struct QuotedBudget {
    std::string quantity;  ///< "intrinsic_work_of_adhesion", "predicted_work_of_adhesion", "predicted_energy_loss"
    std::string symbol;    ///< "W_int", "W_app (7)", "E_loss (10)"
    std::string surface, elastomer;  ///< empty where it is of the whole study
    std::string unit;                ///< SI
    double standard_error = 0.0;
    std::vector<BudgetRow> rows;  ///< the largest first; the noise of all measured values is one row
};

/// Budgets of W_int, then of every pair's predictions; those without standard errors are left out.
[[nodiscard]] std::vector<QuotedBudget> budgets_of(const study::Conclusions& conclusions);

/// "The scatter of W_app between elastomers contributes 62 % of the variance of W_int. Halving it would reduce the
/// standard error from 2.4 mJ/m² to 1.6 mJ/m²"; empty where nothing is uncertain.
[[nodiscard]] std::string budget_sentence(const QuotedBudget& budget);

/// Tables of budgets for a screen of so many columns.
[[nodiscard]] std::string budget_text(const study::StudyResult& result, std::size_t width);

}  // namespace setae::output
