// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/numerics/dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace setae::numerics {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd solved_symmetric(const MatrixXd& matrix, const MatrixXd& right) { return matrix.ldlt().solve(right); }
VectorXd solved_symmetric(const MatrixXd& matrix, const VectorXd& right) { return matrix.ldlt().solve(right); }

VectorXd solved(const MatrixXd& matrix, const VectorXd& right) { return matrix.partialPivLu().solve(right); }
MatrixXd inverse(const MatrixXd& matrix) { return matrix.inverse(); }
bool invertible(const MatrixXd& matrix) { return Eigen::FullPivLU<MatrixXd>(matrix).isInvertible(); }

int rank(const Eigen::MatrixXd& matrix) { return static_cast<int>(matrix.colPivHouseholderQr().rank()); }

std::optional<MatrixXd> cholesky(const MatrixXd& matrix) {
    const Eigen::LLT<MatrixXd> factor(matrix);
    if (factor.info() != Eigen::Success) return std::nullopt;
    return factor.matrixL();
}

std::optional<MatrixXd> inverse_positive_definite(const MatrixXd& matrix) {
    const Eigen::LLT<MatrixXd> factor(matrix);
    if (factor.info() != Eigen::Success) return std::nullopt;
    return factor.solve(MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

VectorXd least_squares(const MatrixXd& design, const VectorXd& values) {
    return design.colPivHouseholderQr().solve(values);
}

SymmetricEigen symmetric_eigen(const MatrixXd& matrix) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
    return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

MatrixXd orthonormal(const MatrixXd& columns) {
    const Eigen::HouseholderQR<MatrixXd> qr(columns);
    return qr.householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
}

MatrixXd product(const MatrixXd& a, const MatrixXd& b) { return a * b; }
MatrixXd transposed_product(const MatrixXd& a, const MatrixXd& b) { return a.transpose() * b; }

}  // namespace setae::numerics
