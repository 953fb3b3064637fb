// SPDX-License-Identifier: GPL-3.0-or-later
// clipper-sum P Q S: what a user of Clipper writes to sum two polygons without holes, P the larger one. P and
// Q are .dat files of one chain of integers each; S becomes the paths that Clipper returns, one after
// another.
#include <fstream>
#include <polyclipping/clipper.hpp>

static ClipperLib::Path read(const char* path) {
  std::ifstream in(path);
  std::size_t size = 0;
  in >> size;
  ClipperLib::Path result;
  for (ClipperLib::cInt x = 0, y = 0; size > 0 && in >> x >> y; --size) result.emplace_back(x, y);
  return result;
}

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  ClipperLib::Paths sum;
  ClipperLib::MinkowskiSum(read(argv[2]), ClipperLib::Paths{read(argv[1])}, sum, true);
  std::ofstream out(argv[3]);
  for (const ClipperLib::Path& path : sum) {
    out << path.size() << '\n';
    for (const ClipperLib::IntPoint& p : path) out << p.X << ' ' << p.Y << '\n';
  }
  return out.flush() ? 0 : 2;
}
