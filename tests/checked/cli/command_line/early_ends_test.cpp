// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/early_ends.hpp"

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class EarlyEnds : public ShellWithRegions {
 protected:
  /// A star of that many vertices.
  void put_star(const std::string& file, int vertices) const {
    run("oplus gen star --n " + std::to_string(vertices) + " --seed 1 -o " + file);
  }
};

TEST_F(EarlyEnds, by_a_limit_of_file_size_are_errors_of_writing) {
  put_star("star.wkt", 500);
  for (const std::string command :
       {"oplus sum star.wkt square.wkt -o s.wkt", "oplus draw star.wkt square.wkt -o s.svg",
        "oplus batch --parts star.wkt -o s.jsonl", "oplus gen star --n 900 -o s.wkt"})
    expect_refusal("ulimit -f 1; " + command, "File too large");
}

TEST_F(EarlyEnds, for_lack_of_memory_are_those_of_invalid_input) {
  put_star("star.wkt", 3000);
  for (const std::string command : {"oplus sum star.wkt star.wkt -o s.wkt --svg s.svg",
                                    "oplus sum star.wkt star.wkt --engine rca -o s.wkt",
                                    "oplus verify star.wkt star.wkt star.wkt"})
    expect_refusal("ulimit -v 50000; " + command, "not enough memory");
  // Of a batch it is the error of a pair.
  const Ran batch = run("ulimit -v 50000; oplus batch --parts star.wkt -o s.jsonl");
  EXPECT_EQ(batch.exit_code, 2);
  EXPECT_EQ(batch.lines_of_err(), 1) << batch.err;
  EXPECT_TRUE(has(batch.err, "not enough memory"));
  for (const std::string& file : files()) EXPECT_FALSE(file.ends_with(".tmp")) << file;
}

}  // namespace
}  // namespace oplus
