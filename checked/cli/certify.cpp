// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/certificates/certificate.hpp"
#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/verify/verdict_text.hpp"
#include "checked/verify/verify.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct CertifyOptions {
  std::string p;
  std::string q;
  std::string sum;
  Overlaps overlaps = Overlaps::refused;
  Boundary boundary = Boundary::closed;
  std::string output = "-";
};

ExitCode certify(const CertifyOptions& options) {
  require_one_standard_input({options.p, options.q, options.sum});
  require_writable({options.output});
  const Region p = read_summand(options.p, nullptr, Extent::bounded, options.overlaps);
  const Region q = read_summand(options.q, nullptr, Extent::bounded, options.overlaps);
  const ClaimedSum given = read_unchecked_sum(options.sum);
  const Verdict verdict = verify(p, q, options.boundary, given);
  for (const std::string& note : verdict.notes) say_note(note);
  if (!verdict.is_sum()) {
    write_text("-", text_of(verdict));
    return ExitCode::not_equal;
  }
  if (const auto vertex = certificates::repeated_vertex(given.region))
    throw UsageError("S has the vertex " + to_string(*vertex) +
                     " twice in a row; a certificate needs an edge between them");
  write_text(options.output, written(options.boundary == Boundary::closed
                                         ? certificates::certificate(p, q, given.region)
                                         : certificates::open_certificate(p, q, given)));
  return ExitCode::done;
}

}  // namespace

void add_certify(Program& program) {
  const auto& [command, options] = program.add(
      "certify", "Write a certificate that a set is the sum of two regions, if it is", certify);
  command.file("P", options.p, "a region (docs/files.md); - is standard input").required();
  command.file("Q", options.q, "the other region").required();
  command.file("S", options.sum, "the sum, from any source").required();
  add_union(command, options.overlaps, "P, and of Q");
  add_open(command, options.boundary,
           "S is the sum of the regions' interiors, with its dangling edges and isolated vertices");
  command.file("-o,--output", options.output,
               "where to write it (docs/certificates.md), by default standard output");
  command.footer(
      "If S is not the sum, prints why, as 'oplus verify' does, and writes nothing. With --union, the\n"
      "certificate is for the unions as 'oplus transform P --scale 1 --union' writes them.\n"
      "\n"
      "Example:\n"
      "  oplus gen tight --n 6 --summand P -o p.wkt\n"
      "  oplus gen tight --n 6 --summand Q -o q.wkt\n"
      "  oplus sum p.wkt q.wkt -o sum.wkt\n"
      "  oplus certify p.wkt q.wkt sum.wkt -o certificate\n"
      "\n"
      "Exit codes:\n"
      "  0  done: it is their sum\n"
      "  1  it is not\n"
      "  2  also: a certificate would be larger than oplus-certified reads");
}

}  // namespace oplus
