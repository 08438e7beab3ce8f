// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

namespace setae::numerics {

// Dense linear algebra of sizes known at run time. It is compiled once, because compilation takes seconds per file.

/// matrix⁻¹ right of a symmetric matrix, by LDLᵀ.
[[nodiscard]] Eigen::MatrixXd solved_symmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
[[nodiscard]] Eigen::VectorXd solved_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// matrix⁻¹ right, by LU with pivots.
[[nodiscard]] Eigen::VectorXd solved(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
[[nodiscard]] Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);
[[nodiscard]] bool invertible(const Eigen::MatrixXd& matrix);

/// Number of linearly independent columns, by Householder's QR with pivots.
[[nodiscard]] int rank(const Eigen::MatrixXd& matrix);

/// The lower triangle L of a symmetric matrix L Lᵀ, and the inverse of that matrix; empty if it is not positive
/// definite.
[[nodiscard]] std::optional<Eigen::MatrixXd> cholesky(const Eigen::MatrixXd& matrix);
[[nodiscard]] std::optional<Eigen::MatrixXd> inverse_positive_definite(const Eigen::MatrixXd& matrix);

/// The x that minimises |design x − values|, by Householder's QR with pivots.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& design, const Eigen::VectorXd& values);

/// Eigenvalues of a symmetric matrix in ascending order, eigenvectors in columns.
struct SymmetricEigen {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};
[[nodiscard]] SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix);

/// Orthonormal basis of the space of the columns, with as many vectors, by Householder's reflections.
[[nodiscard]] Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

/// a b and aᵀ b.
[[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
[[nodiscard]] Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace setae::numerics
