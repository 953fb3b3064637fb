// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/merge_shards.hpp"

#include "tests/checked/cli/batch/job_shell.hpp"

namespace oplus {
namespace {

class MergedShards : public JobShell {
 protected:
  void compute(const std::string& job, int index, int of) const {
    run("oplus batch " + job + " --shard " + std::to_string(index) + "/" + std::to_string(of) +
        " -o s" + std::to_string(index));
  }

  /// The names of all, but not in order.
  std::string compute_all(const std::string& job, int of) const {
    std::string names;
    for (int i = of; i >= 1; --i) {
      compute(job, i, of);
      names.insert(i % 2 == 0 ? 0 : names.size(), " s" + std::to_string(i));
    }
    return names;
  }
};

TEST_F(MergedShards, are_the_output_of_one_run) {
  for (const std::string& job : jobs) {
    const Ran whole = one_run(job, "whole");
    for (const int of : {1, 2, 3, 5, 50}) {
      const std::string names = compute_all(job, of);
      const Ran ran = run("oplus batch merge" + names + " -o merged");
      ASSERT_EQ(content("merged"), whole.out) << job << ", " << of;
      EXPECT_EQ(ran.exit_code, whole.exit_code) << job << ", " << of;
      EXPECT_EQ(ran.err, whole.err) << job << ", " << of;
      EXPECT_EQ(run("oplus batch merge" + names).out, whole.out);
    }
  }
}

TEST_F(MergedShards, may_have_been_resumed) {
  const std::string whole = one_run(jobs[1], "whole").out;
  const std::string names = compute_all(jobs[1], 3);
  for (const std::string file : {"s1", "s2", "s3"}) {
    const std::string shard = content(file);
    put(file, shard.substr(0, shard.size() / 2));
    run("oplus batch " + jobs[1] + " --resume --shard " + file.substr(1) + "/3 -o " + file);
    EXPECT_EQ(content(file), shard);
  }
  EXPECT_EQ(run("oplus batch merge" + names).out, whole);
  // What was computed in one piece, too.
  run("oplus batch " + jobs[1] + " --resume -o s4");
  EXPECT_EQ(run("oplus batch merge s4").out, whole);
}

TEST_F(MergedShards, may_be_more_than_files_are_open) {
  const std::string names = compute_all("--parts parts.txt", 60);
  const std::string merge = "oplus batch merge" + names;
  EXPECT_EQ(run("ulimit -Sn 40; " + merge).out, one_run("--parts parts.txt", "whole").out);
  expect_refusal("ulimit -n 40; " + merge, "cannot be opened (Too many open files)");
}

TEST_F(MergedShards, are_refused_unless_they_are_all_of_one_job) {
  compute("pairs.tsv", 1, 2);
  run("mkdir other && mv s1* other");
  compute("pairs.tsv --digits 2", 1, 4);
  run("mkdir more && mv s1* more");
  compute_all("pairs.tsv", 4);
  expect_refusal("oplus batch merge s1 s3 s4", "oplus: shard 2 of 4 is missing\n");
  expect_refusal("oplus batch merge s4", "oplus: shard 1 of 4 is missing; so are 2 more\n");
  expect_refusal("oplus batch merge s1 s2 s2 s3 s4", "s2 and s2 are both shard 2 of 4");
  expect_refusal("oplus batch merge s1 s2 s3 s4 other/s1",
                 "other/s1 is of another job than s1: it is shard 1 of 2, not of 4");
  expect_refusal("oplus batch merge s2 s3 s4 more/s1",
                 "more/s1 is of another job than s2: its options are PAIRS pairs.tsv --digits 2");
  expect_refusal("oplus batch merge s1 s2 s3 missing", "missing.oplus-job is missing");
  run("cp s2.oplus-job lost.oplus-job");
  expect_refusal("oplus batch merge s1 lost s3 s4", "lost cannot be opened (No such file");
  const std::string shard = content("s2"), job = content("s2.oplus-job");
  put("s2", shard.substr(0, shard.size() - 1));
  expect_refusal("oplus batch merge s1 s2 s3 s4", "s2 is cut or was changed: it has ");
  put("s2", shard);
  put("s2.oplus-job", job.substr(0, job.find(",\"bytes")) + "}\n");
  expect_refusal("oplus batch merge s1 s2 s3 s4", "s2 is not complete; its command goes on with");
  put("s2.oplus-job", job);
  put("s2", std::string(shard.size() - 1, ' ') + "\n");
  expect_refusal("oplus batch merge s1 s2 s3 s4 -o new", "a line that oplus batch did not write");
  // The same number of bytes, but not of lines.
  compute_all("--parts parts.txt --format area", 4);
  std::string changed = content("s2");
  changed[changed.find('\n')] = ' ';
  put("s2", changed);
  expect_refusal("oplus batch merge s1 s2 s3 s4 -o new", " has more lines than the other shards");
  expect_refusal("oplus batch merge s1 s2 s3 s4 -o no/new", "no/new");
  expect_refusal("oplus batch merge", "SHARDS is required; see oplus batch merge --help");
  expect_refusal("oplus batch merge s1 --digits 3", "merge excludes --digits");
  expect_refusal("oplus batch pairs.tsv merge s1", "merge excludes PAIRS");
}

}  // namespace
}  // namespace oplus
