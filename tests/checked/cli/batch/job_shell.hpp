// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/checked/cli/shell.hpp"

namespace oplus {

/// Batches of several forms in the folder, with errors, ids and rotations.
class JobShell : public Shell {
 protected:
  JobShell() {
    std::string pairs, parts;
    for (int i = 1; i <= 12; ++i) {
      const std::string side = std::to_string(i);
      const std::string box = "POLYGON((0 0," + side + " 0," + side + " 1,0 1,0 0))";
      const std::string corner = "POLYGON((0 0,1/3 0,0 " + side + "/7,0 0))";
      const std::string bow_tie = "POLYGON((0 0,1 1,1 0,0 1,0 0))";
      pairs += i % 5 == 0   ? "# " + side + "\n\n"
               : i % 5 == 1 ? R"({"p": ")" + box + R"(", "q": ")" + corner +
                                  R"(", "id": {"error": "none", "line": 7}})" + "\n"
               : i % 5 == 2 ? bow_tie + "\t" + box + "\n"
                            : box + "\t" + corner + "\n";
      if (i <= 4) parts += "box" + side + "\t" + box + "\n\t" + corner + "\n";
      if (i == 3) parts += "bow\t" + bow_tie + "\n";
    }
    put("pairs.tsv", pairs);
    put("parts.txt", parts);
    put("none.tsv", "# no pair\n");
  }

  const std::vector<std::string> jobs = {
      "pairs.tsv",
      "pairs.tsv --rotations 0,30,90 --operation nfp",
      "none.tsv",
      "--parts parts.txt --format area",
      "--parts parts.txt --unordered --rotation-step 90 --digits 3",
      "--parts parts.txt --with parts.txt --operation ifp",
  };

  /// The exit code and the output of one run, to be found in the file too.
  Ran one_run(const std::string& job, const std::string& file) const {
    Ran ran = run("oplus batch " + job + " -o " + file);
    ran.out = content(file);
    return ran;
  }
};

}  // namespace oplus
