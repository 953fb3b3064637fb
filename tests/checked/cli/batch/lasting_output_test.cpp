// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/lasting_output.hpp"

#include "tests/checked/cli/batch/job_shell.hpp"

namespace oplus {
namespace {

class LastingOutputs : public JobShell {};

std::string resuming(const std::string& job) { return "oplus batch " + job + " --resume -o out"; }

TEST_F(LastingOutputs, are_those_of_one_run_wherever_they_were_cut) {
  for (const std::string& job : jobs) {
    const Ran whole = one_run(job, "whole");
    put("out", "");
    const Ran first = run(resuming(job));
    EXPECT_EQ(content("out"), whole.out) << job;
    EXPECT_EQ(first.err, whole.err) << job;
    // Around the ends of some lines, and now and then between.
    std::size_t ends = 0;
    for (std::size_t bytes = 0; bytes <= whole.out.size(); ++bytes) {
      const bool is_end = bytes < whole.out.size() && whole.out[bytes] == '\n';
      if (is_end) ++ends;
      const bool is_behind_end = bytes > 0 && whole.out[bytes - 1] == '\n';
      if (bytes % 397 != 0 && !((is_end || is_behind_end) && ends % 4 == 1)) continue;
      put("out", whole.out.substr(0, bytes));
      const Ran ran = run(resuming(job) + (bytes % 2 == 0 ? " --threads 1" : ""));
      ASSERT_EQ(content("out"), whole.out) << job << ", " << bytes;
      ASSERT_EQ(ran.exit_code, whole.exit_code) << job << ", " << bytes;
      // Of errors, also those that were there.
      const std::string err = whole.exit_code == 0 ? ran.err : whole.err;
      ASSERT_EQ(ran.err, err) << job << ", " << bytes;
    }
    put("out", whole.out.substr(0, whole.out.size() / 2) + std::string(100, '\0'));
    run(resuming(job));
    EXPECT_EQ(content("out"), whole.out) << job;
  }
}

TEST_F(LastingOutputs, begin_where_there_is_no_file) {
  expect_output(resuming("square") + " 2>err; ls",
                "err\nnone.tsv\npairs.tsv\nparts.txt\n");  // what cannot be read leaves nothing
  EXPECT_EQ(run(resuming("pairs.tsv")).exit_code, 2);      // has errors
  EXPECT_EQ(content("out"), one_run("pairs.tsv", "whole").out);
  EXPECT_TRUE(has(content("out.oplus-job"), "\"options\":[\"PAIRS\",\"pairs.tsv\"]"));
  // A shard that does not resume says the same beside it.
  run("oplus batch pairs.tsv --shard 1/1 -o shard");
  EXPECT_EQ(content("shard.oplus-job"), content("out.oplus-job"));
}

class KilledBatch : public JobShell {
 protected:
  KilledBatch() {
    std::string pairs;
    for (int i = 0; i < 200; ++i) {
      const std::string side = std::to_string(i + 1);
      pairs += "{\"p\": \"POLYGON((0 0," + side + " 0," + side +
               " 1,0 0))\", \"q\": \"POLYGON((0 0,1 0,0 1,0 0))\", \"id\": \"" +
               std::string(200, 'x') + "\"}\n";
    }
    put("small.tsv", pairs);
    // A pair that takes so long that the others are written before it ends.
    run("oplus gen star --n 200 --seed 1 -o star.wkt");
    run("(cat small.tsv; paste star.wkt star.wkt) >long.tsv");
  }
};

TEST_F(KilledBatch, goes_on_to_the_output_of_one_run) {
  const std::string whole = one_run("long.tsv", "whole").out;
  std::size_t kills = 0;
  for (const int bytes : {1, 20000, 60000}) {
    const Ran ran =
        run("set -m; rm -f out*\n"
            "oplus batch long.tsv --resume -o out --threads 1 2>err & child=$!\n"
            "until [ \"$(cat out 2>err | wc -c)\" -ge " +
            std::to_string(bytes) +
            " ] || ! kill -0 $child; do sleep 0.001; done 2>err\n"
            "kill -KILL $child; wait $child 2>/dev/null; echo $?");
    if (ran.out == "137\n") ++kills;
    const std::string kept = content("out");
    EXPECT_EQ(kept, whole.substr(0, kept.size()));
    EXPECT_EQ(run(resuming("long.tsv")).exit_code, 0);
    EXPECT_TRUE(content("out") == whole) << bytes;
  }
  EXPECT_GT(kills, 0U);
}

TEST_F(KilledBatch, goes_on_after_the_disk_was_full) {
  const std::string whole = one_run("small.tsv", "whole").out;
  for (const int kilobytes : {1, 7, 50}) {
    run("rm -f out*");
    const Ran full = run("ulimit -f " + std::to_string(kilobytes) + "; " + resuming("small.tsv"));
    EXPECT_EQ(full.exit_code, 2);
    EXPECT_TRUE(has(full.err, "oplus: cannot write out: File too large"));
    EXPECT_EQ(content("out"), whole.substr(0, static_cast<std::size_t>(kilobytes) * 1024));
    EXPECT_EQ(run(resuming("small.tsv")).exit_code, 0);
    EXPECT_TRUE(content("out") == whole) << kilobytes;
  }
}

TEST_F(KilledBatch, keeps_its_lines_when_interrupted) {
  const std::string whole = one_run("long.tsv", "whole").out;
  const Ran ran =
      run("set -m; oplus batch long.tsv --resume -o out --threads 1 2>err & child=$!\n"
          "until [ -s out ] || ! kill -0 $child; do sleep 0.001; done 2>err\n"
          "kill -INT $child; wait $child 2>/dev/null; compgen -G '*.tmp'");
  EXPECT_EQ(ran.out, "");
  const std::string kept = content("out");
  EXPECT_TRUE(kept.ends_with("}\n"));
  EXPECT_EQ(kept, whole.substr(0, kept.size()));
}

/// The lines have ids of 10 KB, so that what is held is seen. The numbers are in KB.
TEST_F(KilledBatch, holds_no_more_for_more_pairs) {
  const auto peak = [&](const std::string& command) {
    const Ran ran = run("/usr/bin/time -f %M -o peak oplus " + command);
    EXPECT_EQ(ran.exit_code, 0) << command << ran.err;
    return std::stol(content("peak"));
  };
  run("sed 's/xx/'\"$(printf '%0500d' 0)\"'/g' small.tsv | head -20 >few.tsv; rm -f out*");
  run("for i in {1..40}; do cat few.tsv; done >many.tsv");
  for (const std::string how :
       {"--resume -o out_", "--threads 3 -o plain_", "--shard 1/2 -o a_", "--shard 2/2 -o b_"}) {
    const long few = peak("batch few.tsv " + how + "few");
    const long many = peak("batch many.tsv " + how + "many");
    EXPECT_LT(many, few + 16000) << how;
  }
  EXPECT_GT(std::filesystem::file_size(folder() / "out_many"), 40000000U);
  run("head -c 30000000 out_many >cut && mv cut out_many");
  const long few = peak("batch merge a_few b_few -o few");
  EXPECT_LT(peak("batch merge a_many b_many -o many"), few + 16000);
  EXPECT_LT(peak("batch many.tsv --resume -o out_many"), few + 16000);
  EXPECT_EQ(run("cmp out_many plain_many && cmp many plain_many").exit_code, 0);
}

class RefusedResume : public JobShell {
 protected:
  RefusedResume() {
    run(resuming("pairs.tsv --digits 3"));
    put("out", content("out").substr(0, 300));
  }

  /// Expects a refusal that leaves the output and its job as they were.
  void expect_no_resume(const std::string& command, const std::string& part) const {
    const std::string output = content("out"), job = content("out.oplus-job");
    expect_refusal(command, part);
    EXPECT_EQ(content("out"), output);
    EXPECT_EQ(content("out.oplus-job"), job);
  }
};

TEST_F(RefusedResume, is_of_another_job) {
  const std::string other = "oplus: out is the output of another job: ";
  expect_no_resume(resuming("pairs.tsv"),
                   other + "its options are PAIRS pairs.tsv --digits 3, not PAIRS pairs.tsv\n");
  expect_no_resume(resuming("pairs.tsv --digits 4"), other + "its options are");
  expect_no_resume(resuming("pairs.tsv --digits 3 --operation nfp"), other + "its options are");
  run("cp pairs.tsv same.tsv");
  expect_no_resume(resuming("same.tsv --digits 3"), other + "its options are");
  expect_no_resume(resuming("pairs.tsv --digits 3 --shard 1/2"), other + "it is of another shard");
  const std::string job = content("out.oplus-job");
  put("out.oplus-job", "{\"oplus\":\"0.0.9" + job.substr(job.find("\",\"options")));
  expect_no_resume(resuming("pairs.tsv --digits 3"), other + "it is of version 0.0.9, not ");
  put("out.oplus-job", job);
  // At its last byte, far behind what was computed.
  std::string input = content("pairs.tsv");
  input[input.size() - 4] = '9';
  put("pairs.tsv", input);
  expect_no_resume(resuming("pairs.tsv --digits 3"), other + "its input has changed");
}

TEST_F(RefusedResume, is_not_of_its_job) {
  const std::string output = content("out");
  const std::string command = resuming("pairs.tsv --digits 3");
  // The last line that is kept is not what comes out.
  const std::size_t last = output.rfind('\n');
  put("out", output.substr(0, last - 3) + "7" + output.substr(last - 2));
  expect_no_resume(command, "out is the output of another job: its last line, 1, comes out diff");
  put("out", one_run("pairs.tsv --digits 3", "whole").out + "{\"line\": 99}\n{\"line\": 100}\nx");
  expect_no_resume(command, "out is the output of another job: its last line, ");
  put("out", "no JSON\n" + output);
  expect_no_resume(command, "out has a line that oplus batch did not write");
  put("out", "{\"line\": 1, \"error\": \"\n" + output);
  expect_no_resume(command, "out has a line that oplus batch did not write");
  put("out", output);
  for (const std::string text : {"", "{", "[]", "{}", "{\"oplus\":1}"}) {
    put("out.oplus-job", text);
    expect_no_resume(command, "out.oplus-job is damaged");
  }
  run("rm out.oplus-job");
  expect_no_resume(command, "out.oplus-job is missing, which --resume and --shard write beside");
}

TEST_F(RefusedResume, cannot_be_done) {
  expect_no_resume("flock out " + resuming("pairs.tsv --digits 3"), "another oplus is writing out");
  expect_no_resume("cat pairs.tsv | " + resuming("-"), "files that can be read again; - ");
  expect_no_resume("oplus batch --parts <(cat parts.txt) --resume -o out", "read again; /dev/fd");
  expect_no_resume("oplus batch pairs.tsv --resume", "need -o FILE");
  expect_no_resume("oplus batch pairs.tsv --resume -o /dev/null", "need -o FILE");
  expect_no_resume("oplus batch pairs.tsv --shard 1/2", "need -o FILE");
  for (const std::string shard : {"0/2", "3/2", "1", "1/", "/2", "x/2", "1/2x", "-1/2"})
    expect_no_resume("oplus batch pairs.tsv -o new --shard=" + shard,
                     "--shard " + shard + " is invalid; expected I/N, 1 <= I <= N");
}

/// With more memory a pair may come out better.
TEST_F(RefusedResume, is_none_of_a_lack_of_memory) {
  const std::string whole = one_run("pairs.tsv --digits 3", "whole").out;
  const std::string output = content("out");
  const std::size_t first = output.find('\n') + 1;
  put("out", output.substr(0, first) +
                 "{\"line\": 2, \"error\": \"there is not enough memory for this input\"}\n");
  run(resuming("pairs.tsv --digits 3"));
  EXPECT_EQ(content("out"), whole);
}

}  // namespace
}  // namespace oplus
