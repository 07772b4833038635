/// Two hundred broken STL files: each is refused or repaired with a message that names the fault and its triangles;
/// what is repaired is healthy and the body that it was.
#include <chrono>
#include <cstring>
#include <functional>
#include <numeric>
#include <random>

#include "fsi/surface/repair.hpp"
#include "fsi/surface/shapes.hpp"
#include "fsi/surface/stl_file.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

using Facets = std::vector<std::array<Vec3, 3>>;
using Random = std::mt19937;

enum class Fate { healthy, repaired, faulty, unreadable };

struct Outcome {
  Fate fate;
  std::string message;
  std::vector<int> triangles;  ///< that findings and steps name
  double volume = 0;
};

/// What `g27 stl FILE --repair OUT` does with the content of a file.
Outcome examined(std::string const& bytes) {
  Outcome out{Fate::healthy, {}, {}};
  auto name = [&out](std::string const& what, std::vector<int> const& triangles) {
    out.message += what + "; ";
    out.triangles.insert(out.triangles.end(), triangles.begin(), triangles.end());
  };
  try {
    StlFile const file = parse_stl(bytes);
    for (std::string const& remark : file.remarks) name(remark, {});
    TriangleSurface const surface = weld(file.facets);
    Diagnosis const before = diagnose(surface);
    for (SurfaceFinding const& f : before.findings) name(fault_name(f.fault), f.triangles);
    if (before.healthy()) {
      out.volume = mass_properties(surface).volume;
      return out;
    }
    Repair const done = repair(surface);
    for (RepairStep const& s : done.steps) name(s.what, s.triangles);
    out.fate = Fate::faulty;
    if (done.surface.size() > 0 && done.diagnosis.healthy()) {
      TriangleSurface const written = weld(parse_stl(binary_stl(done.surface)).facets);
      REQUIRE(diagnose(written).healthy());
      out.fate = Fate::repaired;
      out.volume = mass_properties(written).volume;
    } else {
      for (SurfaceFinding const& f : done.diagnosis.findings) name(fault_name(f.fault), {});
    }
  } catch (SurfaceError const& error) {
    out.fate = Fate::unreadable;
    out.message = error.what();
  }
  return out;
}

double uniform(Random& random, double a, double b) { return std::uniform_real_distribution(a, b)(random); }
std::size_t below(Random& random, std::size_t n) {
  return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
}

Facets facets_of(TriangleSurface const& s) {
  Facets out;
  for (std::size_t t = 0; t < s.size(); ++t) out.push_back(s.corners(t));
  return out;
}

/// One of four bodies of size 1, anyhow turned, in single precision.
TriangleSurface body(Random& random, double size = 1) {
  double const edge = uniform(random, 0.15, 0.3);
  TriangleSurface s;
  switch (below(random, 4)) {
    case 0:
      s = make_box({1, 0.8, 0.6}, edge);
      break;
    case 1:
      s = make_sphere(0.5, edge);
      break;
    case 2:
      s = make_cylinder(0.4, 1, edge);
      break;
    default:
      s = make_tetrahedron(1, edge);
  }
  Vec3 axis{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0.1, 1)};
  axis = (1 / length(axis)) * axis;
  double const angle = uniform(random, 0, 3);
  for (Vec3& x : s.vertices) {
    x = size * (std::cos(angle) * x + std::sin(angle) * cross(axis, x) + ((1 - std::cos(angle)) * dot(axis, x)) * axis);
    for (double& c : x) c = static_cast<double>(static_cast<float>(c));
  }
  return s;
}

std::string binary(Facets const& facets, std::string const& header = "binary") {
  TriangleSurface s;
  for (auto const& f : facets) {
    int const n = static_cast<int>(s.vertices.size());
    s.vertices.insert(s.vertices.end(), f.begin(), f.end());
    s.triangles.push_back({n, n + 1, n + 2});
  }
  std::string out = binary_stl(s);
  std::fill(out.begin(), out.begin() + 80, ' ');
  std::copy(header.begin(), header.end(), out.begin());
  return out;
}

std::string ascii(Facets const& facets) {
  std::string out = "solid body\n";
  char line[128];
  for (auto const& f : facets) {
    out += " facet normal 0 0 0\n  outer loop\n";
    for (Vec3 const& x : f) {
      std::snprintf(line, sizeof line, "   vertex %.17g %.17g %.17g\n", x[0], x[1], x[2]);
      out += line;
    }
    out += "  endloop\n endfacet\n";
  }
  return out + "endsolid body\n";
}

std::string either(Random& random, Facets const& facets) {
  return below(random, 2) == 0 ? binary(facets) : ascii(facets);
}

void put_count(std::string& bytes, std::uint32_t count) { std::memcpy(bytes.data() + 80, &count, 4); }
void put_float(std::string& bytes, std::size_t facet, std::size_t number, float value) {
  std::memcpy(bytes.data() + 84 + 50 * facet + 12 + 4 * number, &value, 4);
}

struct Broken {
  std::string bytes;
  double volume = 0;  ///< of the body that was broken
};

struct Damage {
  char const* name;
  Fate fate;
  std::vector<std::string> words;  ///< of the message
  double tolerance;                ///< of a repaired volume, relative
  std::function<Broken(Random&)> make;
};

constexpr double single = 1e-6;  ///< corners in single precision, moved by up to 6e-8 of the size
constexpr double chords = 0.03;  ///< a hole of three edges in a body of some hundred triangles, closed by its chord

/// A damage to the facets of a body.
template <class F>
std::function<Broken(Random&)> facets_damage(F const& f) {
  return [f](Random& random) {
    TriangleSurface const s = body(random);
    Facets facets = facets_of(s);
    f(random, facets);
    return Broken{either(random, facets), mass_properties(s).volume};
  };
}

/// A damage to the bytes of a file.
template <class F>
std::function<Broken(Random&)> binary_damage(F const& f) {
  return [f](Random& random) {
    TriangleSurface const s = body(random);
    std::string bytes = binary(facets_of(s));
    f(random, bytes, s.size());
    return Broken{bytes, mass_properties(s).volume};
  };
}

template <class F>
std::function<Broken(Random&)> ascii_damage(F const& f) {
  return [f](Random& random) {
    TriangleSurface const s = body(random);
    std::string bytes = ascii(facets_of(s));
    f(random, bytes, s.size());
    return Broken{bytes, mass_properties(s).volume};
  };
}

/// Replaces the n-th occurrence of a word.
void replace(std::string& text, std::string const& word, std::size_t n, std::string const& by) {
  std::size_t at = text.find(word);
  for (; n > 0; --n) at = text.find(word, at + 1);
  REQUIRE(at != std::string::npos);
  text.replace(at, word.size(), by);
}

void append(Facets& a, Facets const& b) { a.insert(a.end(), b.begin(), b.end()); }
Facets turned(Facets facets) {
  for (auto& f : facets) std::swap(f[0], f[1]);
  return facets;
}
Facets moved(Facets facets, Vec3 const& by) {
  for (auto& f : facets) {
    for (Vec3& x : f) x = x + by;
  }
  return facets;
}

/// The middle of the first side of a facet; `other`: the facet across.
Vec3 middle(Facets const& facets, std::size_t facet, std::size_t& other, std::size_t& corner) {
  Vec3 const a = facets[facet][0], b = facets[facet][1];
  for (other = 0; other < facets.size(); ++other) {
    for (corner = 0; corner < 3; ++corner) {
      if (facets[other][corner] == b && facets[other][(corner + 1) % 3] == a) {
        Vec3 m = 0.5 * (a + b);
        for (double& c : m) c = static_cast<double>(static_cast<float>(c));
        return m;
      }
    }
  }
  FAIL("the body is not closed");
  return {};
}

/// Divides a facet at a point of its side that starts at `corner`.
void divide(Facets& facets, std::size_t facet, std::size_t corner, Vec3 const& at) {
  auto const f = facets[facet];
  Vec3 const a = f[corner], b = f[(corner + 1) % 3], c = f[(corner + 2) % 3];
  facets[facet] = {a, at, c};
  facets.push_back({at, b, c});
}

std::vector<Damage> damages() {
  return {
      {"a triangle removed",
       Fate::repaired,
       {"open edges", "closed holes"},
       single,
       facets_damage(
           [](Random& r, Facets& f) { f.erase(f.begin() + static_cast<std::ptrdiff_t>(below(r, f.size()))); })},
      {"two neighbours removed",
       Fate::repaired,
       {"open edges", "closed holes with 2"},
       chords,
       [](Random& r) {
         TriangleSurface const s = make_sphere(0.5, 0.12);  // two of 500 triangles: below 2 % of the area
         Facets f = facets_of(s);
         std::size_t const t = below(r, f.size());
         std::size_t other = 0, corner = 0;
         middle(f, t, other, corner);
         f.erase(f.begin() + static_cast<std::ptrdiff_t>(std::max(t, other)));
         f.erase(f.begin() + static_cast<std::ptrdiff_t>(std::min(t, other)));
         return Broken{either(r, f), mass_properties(s).volume};
       }},
      {"a large hole", Fate::faulty, {"open edges"}, 0, facets_damage([](Random& r, Facets& f) {
         Vec3 n{uniform(r, -1, 1), uniform(r, -1, 1), uniform(r, 0.5, 1)};
         n = (1 / length(n)) * n;
         std::erase_if(f, [&](auto const& t) { return dot(n, t[0] + t[1] + t[2]) > 0.45; });
       })},
      {"some triangles flipped",
       Fate::repaired,
       {"inconsistent orientation", "turned triangles"},
       single,
       facets_damage([](Random& r, Facets& f) {
         for (int k = 0; k < 5; ++k) {
           auto& t = f[below(r, f.size() / 5) + static_cast<std::size_t>(k) * (f.size() / 5)];
           std::swap(t[0], t[2]);
         }
       })},
      {"inside out",
       Fate::repaired,
       {"inward shells", "turned triangles of inward"},
       single,
       facets_damage([](Random&, Facets& f) { f = turned(f); })},
      {"duplicates",
       Fate::repaired,
       {"duplicate triangles", "removed duplicate"},
       single,
       facets_damage([](Random& r, Facets& f) {
         for (int k = 0; k < 4; ++k) {
           auto t = f[below(r, f.size())];
           std::rotate(t.begin(), t.begin() + 1, t.end());
           f.push_back(t);
         }
       })},
      {"duplicates the other way round",
       Fate::repaired,
       {"duplicate triangles", "removed duplicate"},
       single,
       facets_damage([](Random& r, Facets& f) {
         auto t = f[below(r, f.size())];
         std::swap(t[1], t[2]);
         f.push_back(t);
       })},
      {"everything twice",
       Fate::repaired,
       {"duplicate triangles", "removed duplicate"},
       single,
       facets_damage([](Random&, Facets& f) { append(f, Facets(f)); })},
      {"not a number",
       Fate::unreadable,
       {"facet ", "not a finite number"},
       0,
       binary_damage([](Random& r, std::string& b, std::size_t n) { put_float(b, below(r, n), below(r, 9), NAN); })},
      {"infinite",
       Fate::unreadable,
       {"facet ", "not a finite number"},
       0,
       binary_damage(
           [](Random& r, std::string& b, std::size_t n) { put_float(b, below(r, n), below(r, 9), -HUGE_VALF); })},
      {"huge",
       Fate::unreadable,
       {"facet ", "beyond 1e12"},
       0,
       binary_damage([](Random& r, std::string& b, std::size_t n) { put_float(b, below(r, n), below(r, 9), 3e37F); })},
      {"not a number, in words",
       Fate::unreadable,
       {"facet 2 ", "not a finite number"},
       0,
       ascii_damage([](Random& r, std::string& b, std::size_t) {
         replace(b, "vertex ", 7, below(r, 2) == 0 ? "vertex nan " : "vertex inf 0 0\nvertex ");
       })},
      {"truncated",
       Fate::unreadable,
       {"truncated", "claims", "holds"},
       0,
       binary_damage([](Random& r, std::string& b, std::size_t) { b.resize(84 + below(r, b.size() - 84)); })},
      {"truncated in words",
       Fate::unreadable,
       {"line ", "truncated"},
       0,
       ascii_damage([](Random& r, std::string& b, std::size_t n) {
         std::size_t at = 0;
         for (std::size_t k = below(r, n - 1) + 1; k > 0; --k) at = b.find("vertex", at + 1);
         b.resize(at + 6);
       })},
      {"truncated between facets",
       Fate::faulty,
       {"endsolid is missing", "open edges"},
       0,
       ascii_damage([](Random& r, std::string& b, std::size_t n) {
         std::size_t at = 0;
         for (std::size_t k = n / 3 + below(r, n / 3); k > 0; --k) at = b.find("endfacet", at + 1);
         b.resize(at + 9);
       })},
      {"nothing", Fate::unreadable, {"is empty"}, 0, [](Random&) { return Broken{}; }},
      {"all corners at one place",
       Fate::faulty,
       {"degenerate", "without three vertices"},
       0,
       facets_damage([](Random&, Facets& f) {
         for (auto& t : f) t = {Vec3{1, 2, 3}, Vec3{1, 2, 3}, Vec3{1, 2, 3}};
       })},
      {"a million facets claimed",
       Fate::unreadable,
       {"claims 1000000 facets"},
       0,
       binary_damage([](Random&, std::string& b, std::size_t) { put_count(b, 1000000); })},
      {"four billion facets claimed",
       Fate::unreadable,
       {"claims 4294967295 facets"},
       0,
       binary_damage([](Random& r, std::string& b, std::size_t) {
         if (below(r, 2) == 0) std::replace(b.begin(), b.end(), '\0', 'x');  // as a text has none
         put_count(b, 0xFFFFFFFF);
       })},
      {"fewer facets claimed",
       Fate::faulty,
       {"bytes after", "open edges"},
       0,
       binary_damage([](Random&, std::string& b, std::size_t n) { put_count(b, static_cast<std::uint32_t>(n / 2)); })},
      {"no facets",
       Fate::unreadable,
       {"holds no facet"},
       0,
       [](Random& r) { return Broken{below(r, 2) == 0 ? binary({}) : ascii({})}; }},
      {"a short head",
       Fate::unreadable,
       {"fewer than the head"},
       0,
       [](Random& r) { return Broken{std::string("head") + std::string(1 + below(r, 70), '\0')}; }},
      {"other text",
       Fate::unreadable,
       {"line 1", "stands where solid is expected"},
       0,
       ascii_damage([](Random& r, std::string& b, std::size_t) { b = (below(r, 2) == 0 ? "v 1 2 3\n" : "# ") + b; })},
      {"text that starts as binary files do",
       Fate::unreadable,
       {"stands where solid is expected"},
       0,
       [](Random& r) { return Broken{"binary STL" + std::string(80 + below(r, 500), ' ') + "end"}; }},
      {"binary that starts as text does",
       Fate::healthy,
       {},
       single,
       [](Random& r) {
         TriangleSurface const s = body(r);
         return Broken{binary(facets_of(s), "solid ascii\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0"),
                       mass_properties(s).volume};
       }},
      {"capitals and carriage returns",
       Fate::healthy,
       {},
       single,
       ascii_damage([](Random&, std::string& b, std::size_t) {
         std::string out;
         for (char const c : b) out += c == '\n' ? "\r\n" : std::string(1, static_cast<char>(std::toupper(c)));
         b = out;
       })},
      {"several solids", Fate::healthy, {}, single, ascii_damage([](Random& r, std::string& b, std::size_t n) {
         for (int k = 0; k < 3; ++k) replace(b, "endfacet", below(r, n), "endfacet\nendsolid\nsolid next");
       })},
      {"bytes at the end",
       Fate::healthy,
       {"bytes after"},
       single,
       binary_damage([](Random& r, std::string& b, std::size_t) { b.resize(b.size() + 1 + below(r, 200), 'x'); })},
      {"a decimal comma",
       Fate::unreadable,
       {"line ", "stands where a number is expected"},
       0,
       ascii_damage([](Random& r, std::string& b, std::size_t n) { replace(b, "vertex ", below(r, n), "vertex 0,"); })},
      {"four corners",
       Fate::unreadable,
       {"'vertex' stands where endloop is expected"},
       0,
       ascii_damage([](Random& r, std::string& b, std::size_t n) {
         replace(b, "  endloop", below(r, n), "vertex 0 0 0\n  endloop");
       })},
      {"a zero byte in text",
       Fate::unreadable,
       {"line "},
       0,
       ascii_damage([](Random& r, std::string& b, std::size_t n) {
         replace(b, "vertex ", below(r, n), std::string("verte\0 ", 7));
       })},
      {"garbage",
       Fate::unreadable,
       {""},
       0,
       [](Random& r) {
         std::string bytes(84 + below(r, 3000), ' ');
         for (char& c : bytes) c = static_cast<char>(below(r, 256));
         return Broken{bytes};
       }},
      {"bodies that intersect", Fate::faulty, {"self-intersections"}, 0, facets_damage([](Random& r, Facets& f) {
         append(f, moved(f, {uniform(r, 0.1, 0.3), uniform(r, 0.1, 0.3), 0.1}));
       })},
      {"a corner pulled through the body",
       Fate::faulty,
       {"self-intersections"},
       0,
       facets_damage([](Random& r, Facets& f) {
         Vec3 const from = f[below(r, f.size())][0], to = -1.5 * from;
         for (auto& t : f) {
           for (Vec3& x : t) {
             if (x == from) x = to;
           }
         }
       })},
      {"a fin", Fate::faulty, {"non-manifold edges"}, 0, facets_damage([](Random& r, Facets& f) {
         auto const& t = f[below(r, f.size())];
         f.push_back({t[0], t[1], 3.0 * t[2]});
       })},
      {"two bodies at a corner", Fate::faulty, {"non-manifold vertices"}, 0, facets_damage([](Random&, Facets& f) {
         Vec3 top = f[0][0];
         for (auto const& t : f) {
           for (Vec3 const& x : t) top = x[2] > top[2] ? x : top;
         }
         Facets other = f;
         for (auto& t : other) {  // the mirror image in the point
           for (Vec3& x : t) x = 2.0 * top - x;
         }
         append(f, turned(other));
       })},
      {"an edge divided on one side",
       Fate::repaired,
       {"open edges", "closed holes", "removed degenerate"},
       single,
       facets_damage([](Random& r, Facets& f) {
         std::size_t const t = below(r, f.size());
         std::size_t other = 0, corner = 0;
         Vec3 const m = middle(f, t, other, corner);
         divide(f, t, 0, m);
       })},
      {"a cap of no height",
       Fate::repaired,
       {"degenerate triangles", "removed degenerate"},
       single,
       facets_damage([](Random& r, Facets& f) {
         std::size_t const t = below(r, f.size());
         std::size_t other = 0, corner = 0;
         Vec3 const a = f[t][0], b = f[t][1], m = middle(f, t, other, corner);
         divide(f, t, 0, m);
         f.push_back({b, m, a});
       })},
      {"collapsed triangles",
       Fate::repaired,
       {"degenerate triangles", "without three vertices"},
       single,
       facets_damage([](Random& r, Facets& f) {
         for (int k = 0; k < 3; ++k) {
           auto t = f[below(r, f.size())];
           t[1] = t[below(r, 2) * 2];
           f.push_back(t);
         }
       })},
      {"cracks", Fate::repaired, {"open edges", "welded vertices"}, 1e-5, facets_damage([](Random& r, Facets& f) {
         for (auto& t : f) {
           for (Vec3& x : t) {
             if (below(r, 4) == 0) x = x + 1e-6 * Vec3{uniform(r, -1, 1), uniform(r, -1, 1), uniform(r, -1, 1)};
           }
         }
       })},
  };
}

}  // namespace

TEST_CASE("two hundred broken files are refused or repaired", "[surface][stl]") {
  auto const all = damages();
  REQUIRE(all.size() == 40);
  std::map<Fate, int> count;
  for (std::size_t k = 0; k < 5 * all.size(); ++k) {
    Damage const& damage = all[k % all.size()];
    Random random(static_cast<unsigned>(2027 + k));
    Broken const broken = damage.make(random);
    auto const start = std::chrono::steady_clock::now();
    Outcome const outcome = examined(broken.bytes);
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ++count[outcome.fate];
    CAPTURE(k, damage.name, outcome.message);
    CHECK(outcome.fate == damage.fate);
    CHECK(seconds < 2);
    for (std::string const& word : damage.words) CHECK(outcome.message.find(word) != std::string::npos);
    if (damage.fate == Fate::repaired || damage.fate == Fate::faulty) {
      CHECK_FALSE(outcome.triangles.empty());
    }
    if (outcome.fate == Fate::repaired || outcome.fate == Fate::healthy) {
      CHECK(outcome.volume == Approx(broken.volume).epsilon(damage.tolerance));
    } else {
      CHECK_FALSE(outcome.message.empty());
    }
  }
  CHECK(count[Fate::repaired] == 55);
  CHECK(count[Fate::faulty] == 40);
  CHECK(count[Fate::unreadable] == 85);
  CHECK(count[Fate::healthy] == 20);
}
