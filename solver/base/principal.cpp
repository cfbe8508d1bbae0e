#include "solver/base/principal.hpp"

#include <Eigen/Eigenvalues>

namespace eerie {

namespace {

Eigen::Matrix3d to_eigen(const SymTensor& s) {
  return (Eigen::Matrix3d() << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz).finished();
}

}  // namespace

double largest_principal(const SymTensor& s) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>()
      .computeDirect(to_eigen(s), Eigen::EigenvaluesOnly)
      .eigenvalues()[2];
}

SymTensor positive_part(const SymTensor& s) {
  // The iterative solver: directions of nearly equal eigenvalues matter here.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> found(to_eigen(s));
  const Eigen::Matrix3d p = found.eigenvectors() * found.eigenvalues().cwiseMax(0.0).asDiagonal() *
                            found.eigenvectors().transpose();
  return {p(0, 0), p(1, 1), p(2, 2), p(0, 1), p(0, 2), p(1, 2)};
}

}  // namespace eerie
