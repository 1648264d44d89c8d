#include "craze/model/cracked_sheet.h"

#include <gtest/gtest.h>

#include "craze/error.h"
#include "craze/mesh/validate.h"
#include "mesh/shuffled.h"
#include "model/states.h"

namespace craze {
namespace {

CrackedSheet plate() {
  const TriangleMesh mesh = test::mesh_of("plate?n=6&jitter=0.3");
  return test::sheet_of(mesh, test::random_stress(mesh, 2));
}

void expect_in_step(const CrackedSheet& sheet) {
  EXPECT_TRUE(validate(sheet.mesh()).empty());
  ASSERT_EQ(sheet.field().elements().size(), static_cast<std::size_t>(sheet.mesh().face_count()));
  ASSERT_EQ(sheet.field().forces().size(), static_cast<std::size_t>(sheet.mesh().vertex_count()));
  StressField fresh = sheet.field();
  fresh.update_forces(sheet.mesh());
  for (std::int32_t v = 0; v < sheet.mesh().vertex_count(); ++v) {
    EXPECT_LT((sheet.field().force(v) - fresh.force(v)).norm(), 1e-12);
  }
}

TEST(CrackedSheet, KeepsMeshAndFieldInStepThroughEveryEdit) {
  CrackedSheet sheet = plate();
  for (std::int32_t h = 0, edits = 0; edits < 60; h = (h + 7) % (3 * sheet.mesh().face_count())) {
    const bool open = sheet.mesh().is_open(h) || sheet.mesh().is_open_vertex(sheet.mesh().from(h));
    if (edits % 3 == 0) {
      sheet.split(h, 0.4);
    } else if (edits % 3 == 1) {
      if (sheet.mesh().is_open(h)) continue;
      sheet.cut(h, edits);
    } else {
      if (open) continue;
      sheet.slide(h, 0.05);
    }
    ++edits;
    expect_in_step(sheet);
  }
}

TEST(CrackedSheet, TakesOtherNumbersAndItsOwnAgain) {
  CrackedSheet sheet = plate();
  const Numbering numbering{test::any_order(sheet.field().forces().size(), 1),
                            test::any_order(sheet.field().elements().size(), 2)};
  for (std::int32_t v = 0; v < sheet.mesh().vertex_count(); ++v) {
    if (sheet.mesh().is_open_vertex(v)) sheet.field().hold(v);
  }
  for (std::int32_t h = 0; h < 90; h += 9) {
    sheet.split(h, 0.4);
    if (!sheet.mesh().is_open(h)) sheet.cut(h, h);
    if (!sheet.mesh().is_open_vertex(sheet.mesh().from(h + 4))) sheet.slide(h + 4, 0.05);
  }
  const CrackedSheet before = sheet;
  sheet.renumber(numbering);
  expect_in_step(sheet);
  const std::int32_t faces = before.mesh().face_count();
  for (std::int32_t f = 0; f < faces; ++f) {
    const std::int32_t was = new_number(numbering.faces, f);
    ASSERT_EQ(new_number(numbering.faces, sheet.mesh().source_face(f)),
              before.mesh().source_face(was));
    ASSERT_EQ(sheet.field().elements()[f].t[0], before.field().elements()[was].t[0]);
    for (int i = 0; i < 3; ++i) {
      const std::int32_t h = 3 * f + i, v = sheet.mesh().from(h),
                         w = before.mesh().from(3 * was + i);
      ASSERT_EQ(new_number(numbering.vertices, v), w);
      ASSERT_EQ(sheet.mesh().position(v), before.mesh().position(w));
      ASSERT_EQ(sheet.mesh().crack_of(h), before.mesh().crack_of(3 * was + i));
      ASSERT_EQ(new_number(numbering.vertices, sheet.mesh().root(v)), before.mesh().root(w));
      ASSERT_EQ(new_number(numbering.faces, sheet.mesh().anchor(v)), before.mesh().anchor(w));
      ASSERT_EQ(sheet.field().force(v), before.field().force(w));
      ASSERT_EQ(sheet.field().node_areas()[v], before.field().node_areas()[w]);
      ASSERT_EQ(sheet.field().is_held(v), before.field().is_held(w));
    }
  }
  sheet.renumber(inverse(numbering));
  EXPECT_EQ(sheet.mesh().positions(), before.mesh().positions());
  EXPECT_EQ(sheet.mesh().triangles(), before.mesh().triangles());
  for (std::int32_t h = 0; h < 3 * faces; ++h) {
    ASSERT_EQ(sheet.mesh().opposite(h), before.mesh().opposite(h));
  }
  for (std::int32_t v = 0; v < before.mesh().vertex_count(); ++v) {
    ASSERT_EQ(sheet.mesh().first_halfedge(v), before.mesh().first_halfedge(v));
  }
}

TEST(CrackedSheet, HoldsCopiesAndNewNodesOfAHeldBorderAndNoOthers) {
  CrackedSheet sheet = plate();
  for (std::int32_t v = 0; v < sheet.mesh().vertex_count(); ++v) {
    if (sheet.mesh().is_open_vertex(v)) sheet.field().hold(v);
  }
  std::int32_t inside = -1, border = -1, spoke = -1;
  for (std::int32_t h = 0; h < 3 * sheet.mesh().face_count(); ++h) {
    const bool from = sheet.mesh().is_open_vertex(sheet.mesh().from(h));
    const bool to = sheet.mesh().is_open_vertex(sheet.mesh().to(h));
    if (sheet.mesh().is_open(h)) {
      border = h;
    } else if (from && !to) {
      spoke = h;
    } else if (!from && !to) {
      inside = h;
    }
  }
  const TriangleMesh::Cut cut = sheet.cut(spoke, 0);
  ASSERT_GE(cut.copy_of_from, 0);
  EXPECT_TRUE(sheet.field().is_held(cut.copy_of_from));
  EXPECT_TRUE(sheet.field().is_held(sheet.split(border, 0.5).vertex));
  EXPECT_FALSE(sheet.field().is_held(sheet.split(inside, 0.5).vertex));
}

TEST(CrackedSheet, RefusesAFieldOfAnotherMesh) {
  const TriangleMesh small = test::mesh_of("plate?n=2"), large = test::mesh_of("plate?n=3");
  EXPECT_THROW(CrackedSheet(small, StressField(large, test::no_cap)), Error);
}

}  // namespace
}  // namespace craze
