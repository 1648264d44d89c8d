#include "craze/model/cracked_sheet.h"

#include <cassert>

#include "craze/error.h"

namespace craze {

CrackedSheet::CrackedSheet(TriangleMesh mesh, StressField field)
    : mesh_(std::move(mesh)), field_(std::move(field)) {
  if (field_.elements().size() != static_cast<std::size_t>(mesh_.face_count()) ||
      field_.forces().size() != static_cast<std::size_t>(mesh_.vertex_count())) {
    throw Error(ErrorKind::request, "wrong number of values", "stress",
                "the field was made for another mesh");
  }
}

TriangleMesh::Split CrackedSheet::split(std::int32_t h, double t) {
  assert(t > 0 && t < 1);
  const std::int32_t from = mesh_.from(h), to = mesh_.to(h);
  const TriangleMesh::Split split = mesh_.split_edge(h, t);
  field_.follow(mesh_, split, from, to, t);
  return split;
}

TriangleMesh::Cut CrackedSheet::cut(std::int32_t h, std::int32_t crack) {
  assert(crack >= 0 && !mesh_.is_open(h));
  const std::int32_t from = mesh_.from(h), to = mesh_.to(h);
  const TriangleMesh::Cut cut = mesh_.cut(h, crack);
  field_.follow(mesh_, from, cut.copy_of_from);
  field_.follow(mesh_, to, cut.copy_of_to);
  return cut;
}

void CrackedSheet::slide(std::int32_t h, double t) {
  assert(t > 0 && t < 1);
  const std::int32_t v = mesh_.from(h), toward = mesh_.to(h);
  const std::vector<Sym3> unstrained = field_.unstrained_stress(mesh_, v);
  mesh_.slide(h, t);
  field_.follow_slide(mesh_, v, toward, t, unstrained);
}

void CrackedSheet::renumber(const Numbering& numbering) {
  mesh_.renumber(numbering);
  field_.renumber(numbering);
}

void CrackedSheet::shrink_to_fit() {
  mesh_.shrink_to_fit();
  field_.shrink_to_fit();
}

}  // namespace craze
