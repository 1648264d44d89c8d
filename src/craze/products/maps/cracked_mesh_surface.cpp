// The cracks of a mesh that comes from a file, recovered from its open edges.
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "craze/error.h"
#include "craze/maps.h"
#include "craze/mesh/components.h"
#include "craze/products/distance/crack_seams.h"
#include "craze/products/maps/map_surface.h"
#include "craze/repair.h"

namespace craze {

namespace {

using Place = std::array<double, 3>;

Place place_of(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

/// A crack's edge: one side of it, and the other where that has the same ends.
struct Seam {
  std::int32_t side;
  std::int32_t mate = -1;
};

/// Every pair of sides once, and every side whose other side is split elsewhere.
std::vector<Seam> pair_sides(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides) {
  using Ends = std::pair<Place, Place>;
  std::map<Ends, std::vector<std::int32_t>> waiting;  // by the ends they run between
  std::vector<Seam> seams;
  for (const std::int32_t h : sides) {
    const Place from = place_of(mesh.position(mesh.from(h)));
    const Place to = place_of(mesh.position(mesh.to(h)));
    const auto other = waiting.find({to, from});
    if (other != waiting.end() && !other->second.empty()) {
      seams[other->second.back()].mate = h;
      other->second.pop_back();
      continue;
    }
    waiting[{from, to}].push_back(static_cast<std::int32_t>(seams.size()));
    seams.push_back({h});
  }
  return seams;
}

/// How far the copies of a vertex move apart, at most.
class Openings {
 public:
  Openings(const TriangleMesh& mesh, const Attribute* displacement)
      : mesh_(mesh), displacement_(displacement) {
    if (!displacement_) return;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.is_open_vertex(v)) copies_[place_of(mesh.position(v))].push_back(v);
    }
  }

  std::array<double, 2> of(const Seam& seam) const {
    if (!displacement_) return {};
    const std::int32_t a = mesh_.from(seam.side), b = mesh_.to(seam.side);
    if (seam.mate < 0) return {widest(a), widest(b)};
    return {between(a, mesh_.to(seam.mate)), between(b, mesh_.from(seam.mate))};
  }

 private:
  double between(std::int32_t v, std::int32_t w) const {
    const double *p = &displacement_->values[3 * static_cast<std::size_t>(v)],
                 *q = &displacement_->values[3 * static_cast<std::size_t>(w)];
    return Vec3(p[0] - q[0], p[1] - q[1], p[2] - q[2]).norm();
  }
  double widest(std::int32_t v) const {
    double width = 0;
    for (const std::int32_t w : copies_.at(place_of(mesh_.position(v)))) {
      width = std::max(width, between(v, w));
    }
    return width;
  }

  const TriangleMesh& mesh_;
  const Attribute* displacement_;
  std::map<Place, std::vector<std::int32_t>> copies_;
};

/// Which cracks meet at each place.
using Meetings = std::map<Place, std::vector<std::int32_t>>;

Meetings meetings_of(const std::vector<MapCrack>& cracks) {
  Meetings at;
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    at[place_of(cracks[i].a)].push_back(static_cast<std::int32_t>(i));
    at[place_of(cracks[i].b)].push_back(static_cast<std::int32_t>(i));
  }
  return at;
}

/// Numbers the cracks by the lines between places where not two of them meet.
void number_lines(std::vector<MapCrack>& cracks, const Meetings& at) {
  std::vector<std::int32_t> line(cracks.size());
  std::iota(line.begin(), line.end(), 0);
  const auto root = [&](std::int32_t i) {
    while (line[i] != i) i = line[i] = line[line[i]];
    return i;
  };
  for (const auto& [place, meeting] : at) {
    if (meeting.size() != 2) continue;
    const std::int32_t a = root(meeting[0]), b = root(meeting[1]);
    line[std::max(a, b)] = std::min(a, b);
  }
  std::map<std::int32_t, std::int32_t> number;
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    const std::int32_t first = root(static_cast<std::int32_t>(i));
    cracks[i].number =
        number.emplace(first, static_cast<std::int32_t>(number.size())).first->second;
  }
}

/// Whether lines of two or more cracks meet there: a vertex has the time of the first.
bool is_junction(const Meetings& at, const Vec3& p) {
  return at.at(place_of(p)).size() > 2;
}

/// A piece from junction to junction has the time of the rest of its line, where there is any.
void time_between_junctions(std::vector<MapCrack>& cracks, const Meetings& at) {
  std::map<std::int32_t, double> known;  // by line: the latest time of pieces that know theirs
  const auto knows = [&](const MapCrack& c) {
    return !is_junction(at, c.a) || !is_junction(at, c.b);
  };
  for (const MapCrack& crack : cracks) {
    if (!knows(crack)) continue;
    const auto [line, is_new] = known.emplace(crack.number, crack.time);
    if (!is_new) line->second = std::max(line->second, crack.time);
  }
  for (MapCrack& crack : cracks) {
    const auto line = known.find(crack.number);
    if (!knows(crack) && line != known.end()) crack.time = line->second;
    crack.times = {crack.time, crack.time};
  }
}

/// A line of several events goes from one time to the next over a piece.
void smooth_times(std::vector<MapCrack>& cracks, const Meetings& at) {
  for (const auto& [place, meeting] : at) {
    if (meeting.size() != 2) continue;
    const double mean = (cracks[meeting[0]].time + cracks[meeting[1]].time) / 2;
    for (const std::int32_t i : meeting) {
      cracks[i].times[place_of(cracks[i].a) == place ? 0 : 1] = mean;
    }
  }
}

/// The pieces that hang together, or what the file calls them.
std::vector<std::int32_t> fragments_of(const SurfaceMesh& open, const TriangleMesh& mesh) {
  const Attribute* named = find_attribute(open.face_attributes, "fragment");
  if (!named || named->components != 1) return find_components(mesh).face;
  std::vector<std::int32_t> fragments;
  for (const double value : named->values) fragments.push_back(static_cast<std::int32_t>(value));
  return fragments;
}

const Attribute* attribute(const SurfaceMesh& mesh, const char* name, int components) {
  const Attribute* found = find_attribute(mesh.vertex_attributes, name);
  return found && found->components == components ? found : nullptr;
}

/// The surface with its cracks open but with no seam of its UVs.
void cut_along_cracks(MapSurface& maps) {
  TriangleMesh cut(maps.surface.positions, maps.surface.triangles);
  for (MapCrack& crack : maps.cracks) {
    // Welding may have moved its ends by a rounding.
    double least = std::numeric_limits<double>::infinity();
    std::int32_t side = -1;
    for (std::int32_t h = 3 * crack.face; h < 3 * crack.face + 3; ++h) {
      for (const std::int32_t from : {cut.from(h), cut.to(h)}) {
        const std::int32_t to = cut.from(h) + cut.to(h) - from;
        const double off = (cut.position(from) - crack.a).squaredNorm() +
                           (cut.position(to) - crack.b).squaredNorm();
        if (off >= least) continue;
        least = off;
        side = h;
        crack.roots = {cut.root(from), cut.root(to)};
      }
    }
    if (side >= 0 && !cut.is_open(side)) cut.cut(side, crack.number);
  }
  maps.cut = std::make_shared<const TriangleMesh>(std::move(cut));
}

}  // namespace

MapSurface map_surface(const SurfaceMesh& cracked, const PostParameters& post,
                       const Context& context) {
  check_uvs(cracked);
  RepairReport report;
  SurfaceMesh open = repair(cracked, {-1}, report, context);
  const TriangleMesh mesh(open.positions, open.triangles);
  const std::vector<std::int32_t> sides = crack_seams(open, mesh);
  if (sides.empty()) {
    throw Error(ErrorKind::request, "no cracks to bake", "open edges",
                "the mesh has no open edges that lie on each other; of a mesh whose cracks were "
                "opened into gaps, give the one with post.gap=0");
  }
  open.source_faces.resize(open.triangles.size());
  std::iota(open.source_faces.begin(), open.source_faces.end(), 0);

  MapSurface maps;
  maps.surface = repair(open, {}, report, context);
  std::vector<std::int32_t> welded(open.triangles.size(), -1);
  const std::vector<std::int32_t> fragments = fragments_of(open, mesh);
  for (std::size_t f = 0; f < maps.surface.triangles.size(); ++f) {
    const std::int32_t source = maps.surface.source_faces[f];
    const auto& uvs = maps.surface.corner_uvs;
    welded[source] = static_cast<std::int32_t>(f);
    maps.pieces.push_back({static_cast<std::int32_t>(f),
                           fragments[source],
                           {uvs[3 * f], uvs[3 * f + 1], uvs[3 * f + 2]}});
  }
  const Attribute* displacement = attribute(open, "displacement", 3);
  const Attribute* time = attribute(open, "crack_time", 1);
  const Openings openings(mesh, displacement);
  maps.has_widths = displacement != nullptr;
  maps.has_times = time != nullptr;
  for (const Seam& seam : pair_sides(mesh, sides)) {
    const std::int32_t a = mesh.from(seam.side), b = mesh.to(seam.side);
    const std::int32_t face = welded[seam.side / 3];
    if (face < 0) continue;
    // A vertex has the time of the first crack that came by.
    const double opened = time ? std::max(time->values[a], time->values[b]) : 0;
    maps.cracks.push_back(
        {mesh.position(a), mesh.position(b), openings.of(seam), opened, 0, face, {opened, opened}});
  }
  const Meetings meetings = meetings_of(maps.cracks);
  number_lines(maps.cracks, meetings);
  time_between_junctions(maps.cracks, meetings);
  smooth_times(maps.cracks, meetings);
  cut_along_cracks(maps);
  if (post.curl != 0) refine_to_bend(maps, maps.surface, context);
  return maps;
}

}  // namespace craze
