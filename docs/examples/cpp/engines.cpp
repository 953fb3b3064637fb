// SPDX-License-Identifier: MIT
// The other algorithms, what they did, where edges came from, and certificates. Link oplus::engines.
#include <iostream>
#include <oplus/engines.hpp>
#include <oplus/oplus.hpp>

int main() {
  auto p = oplus::polygon({{0, 0}, {4, 0}, {2, 3}});
  auto q = oplus::polygon({{0, 0}, {1, 0}, {0, 1}});
  auto expected = minkowski_sum(p, q);
  for (const std::string& name : oplus::engine_names()) {
    auto sum = minkowski_sum(p, q, {.engine = oplus::engine(name)});
    std::cout << name << (sum == expected ? ": the same" : ": differs") << '\n';
  }

  // What a run did: counts, times and areas, each with a name.
  auto by_rca = minkowski_sum(p, q, {.engine = oplus::engine("rca")});
  const oplus::Statistics& statistics = by_rca.statistics();
  for (const oplus::Statistic& one : statistics)
    if (std::holds_alternative<std::size_t>(one.value))
      std::cout << one.name << ": " << statistics.count(one.name) << '\n';
  const std::string time = "seconds for the arrangement";
  if (statistics.contains(time) && statistics.seconds(time) < oplus::Seconds(60))
    std::cout << "arranged in less than a minute\n";

  // For each edge of the result, an edge of one summand and a vertex of the other, by their indices.
  auto sum = minkowski_sum(p, q, {.with_origins = true});
  const oplus::PlanarSet& value = sum.value();
  for (std::size_t i = 0; i < sum.origins().size(); ++i)
    for (const oplus::Origin& origin : sum.origins()[i]) {
      const oplus::VertexIndex edge = origin.edge, vertex = origin.vertex;
      std::cout << "edge from " << value.outer[0][i].x << ' ' << value.outer[0][i].y << ": edge "
                << edge.vertex << " of " << (origin.edge_of == oplus::Summand::P ? 'P' : 'Q')
                << " at vertex " << vertex.vertex << '\n';
    }

  // What a proved program, oplus-certified, needs to check it; a wrong sum is refused.
  std::string certificate = certify(p, q, {sum.region().region(), {}, {}});
  std::cout << certificate.substr(0, certificate.find('\n')) << '\n';
  try {
    certify(p, q, {p.region(), {}, {}});
  } catch (const oplus::InvalidInput& error) {
    std::cout << error.what() << '\n';
  }
}
