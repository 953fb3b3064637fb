// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/certified_engine.hpp"

#include <filesystem>
#include <system_error>

#include "checked/certificates/certificate.hpp"
#include "checked/engines/engines.hpp"
#include "properties/compare/engine_failure.hpp"
#include "properties/runner/checked_engines.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

using Kind = EngineFailure::Kind;

std::string certificate_of(const Region& p, const Region& q, const ClaimedSum& sum,
                           Boundary boundary) {
  try {
    return written(boundary == Boundary::closed ? certificates::certificate(p, q, sum.region)
                                                : certificates::open_certificate(p, q, sum));
  } catch (const certificates::PointOutsideSum& e) {
    throw EngineFailure(Kind::crashed, "no certificate",
                        std::string("no certificate: ") + e.what());
  }
}

PlanarSet certified_sum(const Region& p, const Region& q, Boundary boundary,
                        const ProcessLimits& limits) {
  PlanarSet sum = find_engine(engines(), "slide")->compute(p, q, boundary, {}).sum;
  const ClaimedSum given = parts_of(sum);
  const EndedProcess ended =
      checked_certificate(boundary == Boundary::closed ? "sum" : "open-sum", p, q, given,
                          certificate_of(p, q, given, boundary), limits);
  if (ended.how == EndedProcess::How::interrupted)
    throw std::system_error(std::make_error_code(std::errc::interrupted));
  if (ended.how == EndedProcess::How::over_time)
    throw EngineFailure(Kind::hung, "oplus-certified", "hung: oplus-certified has no answer");
  if (!says_certified(ended))
    throw EngineFailure(Kind::crashed, "not certified",
                        "oplus-certified: " + ended.output + ended.errors);
  return sum;
}

}  // namespace

EndedProcess checked_certificate(const std::string& claim, const Region& p, const Region& q,
                                 const ClaimedSum& set, const std::string& certificate,
                                 const ProcessLimits& limits) {
  const TemporaryFolder folder("oplus-certified");
  const auto file = [&](const char* name, const std::string& text) {
    const std::string path = folder.path() / name;
    write_file(path, text);
    return path;
  };
  const PlanarSet features{{}, {}, set.dangling_edges, set.isolated_vertices};
  return run_program(
      {program_beside("oplus-certified"), claim, file("p.wkt", wkt(p)), file("q.wkt", wkt(q)),
       file("set.wkt", written(features, set.region, Format::wkt)),
       file("certificate", certificate)},
      limits);
}

bool says_certified(const EndedProcess& ended) {
  return ended.how == EndedProcess::How::exited && ended.code == 0 &&
         ended.output.starts_with("certified: ");
}

Engine certified_engine(ProcessLimits limits) {
  limits.is_quiet = true;
#ifdef __SANITIZE_ADDRESS__
  limits.address_space_mb = 0;
#endif
  Engine engine =
      named_engine("certified", [limits](const Region& p, const Region& q, Boundary boundary) {
        return certified_sum(p, q, boundary, limits);
      });
  engine.what = "slide's sums with certificates that oplus-certified accepts";
  return engine;
}

bool can_certify() { return std::filesystem::exists(program_beside("oplus-certified")); }

}  // namespace oplus
