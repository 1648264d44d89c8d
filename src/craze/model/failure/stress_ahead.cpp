#include "craze/model/failure/stress_ahead.h"

namespace craze {

namespace {

constexpr double least_cosine = 0.5;  // between the normals of a face and of the tip

Sym3 turned(const Sym3& stress, const Vec3& from, const Vec3& to) {
  const Mat3 turn = Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
  const Mat3 m = turn * stress.matrix() * turn.transpose();
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)};
}

}  // namespace

Sym3 StressAhead::mean(const TriangleMesh& mesh, const StressField& field, std::int32_t v,
                       double length) {
  const Vec3 &tip = mesh.position(v), &normal = field.normals()[v];
  const Vec3 back = mesh.way(v, mesh.to(mesh.first_halfedge(v)));
  reached_.clear();
  faces_.clear();
  const auto reach = [&](std::int32_t f) {
    if (reached_.insert(static_cast<std::uint64_t>(f))) faces_.push_back(f);
  };
  mesh.for_each_outgoing(v, [&](std::int32_t h) { reach(TriangleMesh::face_of(h)); });
  Sym3 sum;
  double weights = 0;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const std::int32_t f = faces_[i];
    const Triangle& t = mesh.triangle(f);
    const Vec3 a = mesh.position_near(t[0], tip), b = mesh.position_near(t[1], tip),
               c = mesh.position_near(t[2], tip);
    const Vec3 arm = (a + b + c) / 3 - tip, across = (b - a).cross(c - a);
    const double inside = 1 - arm.squaredNorm() / (length * length), twice = across.norm();
    if (!(inside > 0) || !(across.dot(normal) > least_cosine * twice)) continue;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t beyond = mesh.opposite(3 * f + k);
      if (beyond >= 0) reach(TriangleMesh::face_of(beyond));
    }
    if (!(arm.dot(back) < 0)) continue;
    const double weight = inside * inside * twice;
    sum += weight * turned(field.stress(mesh, f), across / twice, normal);
    weights += weight;
  }
  return weights > 0 ? (1 / weights) * sum : sum;
}

}  // namespace craze
