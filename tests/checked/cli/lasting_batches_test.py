#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""lasting_batches_test.py OPLUS: what `oplus batch` writes after kills, cuts and full disks, and from shards, is what one run
writes, byte for byte; and what is of another job is refused, and left as it was."""

import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

RECTANGLE = "POLYGON((0 0,{0} 0,{0} 1,0 1,0 0))".format
CORNER = "POLYGON((0 0,1/3 0,0 {0}/7,0 0))".format
BOW_TIE = "POLYGON((0 0,1 1,1 0,0 1,0 0))"
# Of several forms, with errors, ids and rotations.
JOBS = ["pairs.tsv", "pairs.tsv --rotations 0,30,90 --operation nfp", "none.tsv", "--parts parts.txt --format area",
        "--parts parts.txt --unordered --rotation-step 90 --digits 3", "--parts parts.txt --with parts.txt --operation ifp"]


def pair_line(i):
    """The i-th one."""
    return ["# a comment\n\n",
            f'{{"p": "{RECTANGLE(i)}", "q": "{CORNER(i)}", "id": {{"error": "none", "line": 7}}}}\n',
            f"{BOW_TIE}\t{RECTANGLE(i)}\n",
            f"{RECTANGLE(i)}\t{CORNER(i)}\n"][i % 4]


class Batches(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.put("pairs.tsv", "".join(map(pair_line, range(1, 13))))
        self.put("parts.txt", "".join(f"box{i}\t{RECTANGLE(i)}\n\t{CORNER(i)}\n" for i in range(1, 5)) + f"bow\t{BOW_TIE}\n")
        self.put("none.tsv", "# no pair\n")

    def put(self, file, content):
        (self.folder / file).write_bytes(content if isinstance(content, bytes) else content.encode())

    def content(self, file):
        return (self.folder / file).read_bytes()

    def run_batch(self, words, limits=None, before=(), **given):
        """Returns the exit code, and standard error."""
        ran = subprocess.run([*before, PROGRAM, "batch", *words.split()], cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True,
                             text=True, preexec_fn=limits and (lambda: resource.setrlimit(*limits)), **given)
        self.assertEqual(ran.stdout, "")
        return ran.returncode, ran.stderr

    def one_run(self, job):
        """Returns the output, the exit code and standard error."""
        ended = self.run_batch(f"{job} -o whole")
        return self.content("whole"), ended

    def assert_refused(self, words, part, **how):
        """By one line, and without changing a file."""
        files = lambda: {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        before = files()
        code, error = self.run_batch(words, **how)
        self.assertEqual((code, error.count("\n"), error[:7]), (2, 1, "oplus: "), f"{words}\n{error}")
        self.assertIn(part, error)
        self.assertEqual(files(), before, words)


class Resumed(Batches):
    def test_is_one_run_wherever_it_was_cut(self):
        for job in JOBS:
            whole, ended = self.one_run(job)
            (self.folder / "out").unlink(missing_ok=True)
            self.assertEqual(self.run_batch(f"{job} --resume -o out"), ended)
            ends = [end.end() for end in re.finditer(b"\n", whole)]
            # Around the ends of some lines, and between.
            cuts = {0, len(whole), *range(0, len(whole), 797), *(end + d for end in ends[::6] for d in (-1, 0, 1) if end + d <= len(whole))}
            for kept in [whole[:cut] for cut in sorted(cuts)] + [whole[:len(whole) // 2] + bytes(100)]:
                self.put("out", kept)
                # Of errors, also of those that were there.
                self.assertEqual(self.run_batch(f"{job} --resume -o out --threads {len(kept) % 3}"), ended, (job, len(kept)))
                self.assertEqual(self.content("out"), whole, (job, len(kept)))

    def test_begins_where_there_is_no_file(self):
        self.assert_refused("missing --resume -o out", "missing")
        self.assertEqual(self.run_batch("pairs.tsv --resume -o out")[0], 2)
        self.assertEqual(self.content("out"), self.one_run("pairs.tsv")[0])
        self.assertIn(b'"options":["PAIRS","pairs.tsv"]', self.content("out.oplus-job"))
        self.run_batch("pairs.tsv --shard 1/1 -o shard")
        self.assertEqual(self.content("shard.oplus-job"), self.content("out.oplus-job"))

    def put_long(self):
        """Many pairs, and one that takes so long that the others are written before it ends."""
        self.put("small.tsv", "".join(f'{{"p": "{RECTANGLE(i)}", "q": "{CORNER(i)}", "id": "{200 * "x"}"}}\n' for i in range(1, 201)))
        star = subprocess.run([PROGRAM, "gen", "star", "--n", "200", "--seed", "1"], capture_output=True, check=True).stdout.strip()
        self.put("long.tsv", self.content("small.tsv") + star + b"\t" + star + b"\n")

    def test_is_one_run_after_a_kill(self):
        self.put_long()
        whole, _ = self.one_run("long.tsv")
        codes = []
        for number, least in [(signal.SIGKILL, 1), (signal.SIGKILL, 20000), (signal.SIGKILL, 50000), (signal.SIGINT, 30000)]:
            shutil.rmtree(self.folder / "at", ignore_errors=True)
            (self.folder / "at").mkdir()
            words = ["batch", "long.tsv", "--resume", "-o", "at/out", "--threads", "1"]
            with subprocess.Popen([PROGRAM, *words], cwd=self.folder) as child:
                out = self.folder / "at/out"
                while child.poll() is None and not (out.exists() and out.stat().st_size >= least):
                    time.sleep(0.001)
                child.send_signal(number)
            codes.append(child.returncode)
            self.assertTrue(whole.startswith(out.read_bytes()))
            self.assertEqual({path.name for path in out.parent.iterdir()}, {"out", "out.oplus-job"})
            if number == signal.SIGINT:
                self.assertTrue(out.read_bytes().endswith(b"}\n"))
            self.assertEqual(self.run_batch(" ".join(words[1:])), (0, ""))
            self.assertEqual(out.read_bytes(), whole)
        self.assertIn(-signal.SIGKILL, codes)
        self.assertIn(codes[3], (-signal.SIGINT, 0))

    def test_is_one_run_after_a_full_disk(self):
        self.put_long()
        whole, _ = self.one_run("small.tsv")
        for size in (1000, 7001, 50002):
            (self.folder / "out").unlink(missing_ok=True)
            code, error = self.run_batch("small.tsv --resume -o out", (resource.RLIMIT_FSIZE, (size, size)))
            self.assertEqual((code, error), (2, "oplus: cannot write out: File too large\n"))
            self.assertEqual(self.content("out"), whole[:size])
            self.assertEqual(self.run_batch("small.tsv --resume -o out"), (0, ""))
            self.assertEqual(self.content("out"), whole)

    def test_holds_no_more_for_more_pairs(self):
        """The lines have ids of 50 KB, so that what is held is seen."""
        def peak(words):
            self.assertEqual(self.run_batch(words, before=("/usr/bin/time", "-q", "-f", "%M", "-o", "peak")), (0, ""))
            return int(self.content("peak"))  # KB

        few = "".join(f'{{"p": "{RECTANGLE(i)}", "q": "{CORNER(i)}", "id": "{50000 * "x"}"}}\n' for i in range(1, 21))
        self.put("few", few)
        self.put("many", 40 * few)
        for how in ("--resume -o {0}.out", "-o {0}.plain", "--shard 1/2 -o {0}.1", "--shard 2/2 -o {0}.2"):
            words = "{0} --threads 3 " + how  # each thread may hold some
            self.assertLess(peak(words.format("many")), peak(words.format("few")) + 16000, how)
        self.assertGreater(len(self.content("many.out")), 40_000_000)
        merged = peak("merge few.1 few.2 -o few.merged")
        self.assertLess(peak("merge many.1 many.2 -o many.merged"), merged + 16000)
        self.put("many.out", self.content("many.out")[:30_000_000])
        self.assertLess(peak("many --threads 3 --resume -o many.out"), merged + 16000)
        for file in ("many.out", "many.merged"):
            self.assertTrue(self.content(file) == self.content("many.plain"), file)

    def test_is_refused_of_another_job(self):
        self.run_batch("pairs.tsv --digits 3 --resume -o out")
        output, job = self.content("out")[:300], self.content("out.oplus-job")
        self.put("out", output)
        other = "oplus: out is the output of another job: "
        its_own = "pairs.tsv --digits 3 --resume -o out"
        self.assert_refused("pairs.tsv --resume -o out",
                            other + "its options are PAIRS pairs.tsv --digits 3, not PAIRS pairs.tsv\n")
        for options in ("pairs.tsv --digits 4", "pairs.tsv --digits 3 --operation nfp", "./pairs.tsv --digits 3"):
            self.assert_refused(f"{options} --resume -o out", other + "its options are ")
        self.assert_refused(f"{its_own} --shard 1/2", other + "it is of another shard")
        self.put("out.oplus-job", re.sub(b'"oplus":"[^"]*', b'"oplus":"0.0.9', job))
        self.assert_refused(its_own, other + "it is of version 0.0.9, not ")
        for text in (b"", b"{", b"[]", b"{}", b'{"oplus":1}'):
            self.put("out.oplus-job", text)
            self.assert_refused(its_own, "out.oplus-job is damaged")
        (self.folder / "out.oplus-job").unlink()
        self.assert_refused(its_own, "out.oplus-job is missing, which --resume and --shard write beside out")
        self.put("out.oplus-job", job)
        # The last line that is kept is not what comes out; or there are more lines than there can be.
        end = output.rindex(b"\n")
        self.put("out", output[:end - 3] + b"7" + output[end - 2:])
        self.assert_refused(its_own, other + "its last line, 1, comes out differently")
        self.put("out", self.one_run("pairs.tsv --digits 3")[0] + b'{"line": 99}\n{"line": 100}\nx')
        self.assert_refused(its_own, other + "its last line, ")
        for line in (b"no JSON\n", b'{"line": 1, "error": "\n'):
            self.put("out", line + output)
            self.assert_refused(its_own, "out has a line that oplus batch did not write")
        self.put("out", output)
        # Far behind what was computed.
        pairs = self.content("pairs.tsv")
        self.put("pairs.tsv", pairs[:-4] + b"9" + pairs[-3:])
        self.assert_refused(its_own, other + "its input has changed")

    def test_is_refused_where_it_cannot_be_done(self):
        self.run_batch("pairs.tsv --resume -o out")
        self.assert_refused("pairs.tsv --resume -o out", "another oplus is writing out", before=("flock", "out"))
        self.assert_refused("- --resume -o out", "--resume and --shard take files that can be read again; - ")
        self.assert_refused("--parts /dev/stdin --shard 1/2 -o new", "files that can be read again; /dev/stdin is not one")
        for words in ("pairs.tsv --resume", "pairs.tsv --shard 1/2", "pairs.tsv --resume -o /dev/null"):
            self.assert_refused(words, "--resume and --shard need -o FILE")
        for shard in ("0/2", "3/2", "1", "1/", "/2", "x/2", "1/2x", "-1/2"):
            self.assert_refused(f"pairs.tsv -o new --shard={shard}", f"--shard {shard} is invalid; expected I/N, 1 <= I <= N")

    def test_computes_again_what_lacked_memory(self):
        whole, ended = self.one_run("pairs.tsv")
        self.run_batch("pairs.tsv --resume -o out")
        self.put("out", whole.splitlines(True)[0] + b'{"line": 2, "error": "there is not enough memory for this input"}\n')
        self.assertEqual(self.run_batch("pairs.tsv --resume -o out"), ended)
        self.assertEqual(self.content("out"), whole)


class Merged(Batches):
    def compute_all(self, job, of, prefix="s"):
        """Returns the names of all, in any order."""
        for i in range(1, of + 1):
            self.run_batch(f"{job} --shard {i}/{of} -o {prefix}{i}")
        names = [f"{prefix}{i}" for i in range(1, of + 1)]
        random.Random(of).shuffle(names)
        return " ".join(names)

    def test_is_one_run(self):
        for job in JOBS:
            whole, ended = self.one_run(job)
            for of in (1, 3, 20):
                self.assertEqual(self.run_batch(f"merge {self.compute_all(job, of)} -o merged"), ended, (job, of))
                self.assertEqual(self.content("merged"), whole, (job, of))

    def test_may_have_been_resumed(self):
        whole, _ = self.one_run(JOBS[1])
        names = self.compute_all(JOBS[1], 3)
        for i in (1, 2, 3):
            shard = self.content(f"s{i}")
            self.put(f"s{i}", shard[:len(shard) // 2])
            self.run_batch(f"{JOBS[1]} --resume --shard {i}/3 -o s{i}")
            self.assertEqual(self.content(f"s{i}"), shard)
        self.run_batch(f"merge {names} -o merged")
        self.assertEqual(self.content("merged"), whole)
        # In one piece, too.
        self.run_batch(f"{JOBS[1]} --resume -o s4")
        self.run_batch("merge s4 -o merged")
        self.assertEqual(self.content("merged"), whole)

    def test_may_be_of_more_files_than_may_be_open_at_first(self):
        names = self.compute_all("--parts parts.txt", 60)
        self.assertEqual(self.run_batch(f"merge {names} -o merged", (resource.RLIMIT_NOFILE, (40, 100)))[0], 2)  # bow
        self.assertEqual(self.content("merged"), self.one_run("--parts parts.txt")[0])
        self.assert_refused(f"merge {names}", "cannot be opened (Too many open files)", limits=(resource.RLIMIT_NOFILE, (40, 40)))

    def test_is_refused_unless_all_are_there_of_one_job(self):
        self.compute_all("pairs.tsv", 2, "half")
        self.compute_all("pairs.tsv --digits 2", 4, "other")
        self.compute_all("pairs.tsv", 4)
        for files, part in [("s1 s3 s4", "oplus: shard 2 of 4 is missing\n"),
                            ("s4", "oplus: shard 1 of 4 is missing; so are 2 more\n"),
                            ("s1 s2 s2 s3 s4", "s2 and s2 are both shard 2 of 4"),
                            ("s1 s2 s3 s4 half1", "half1 is of another job than s1: it is shard 1 of 2, not of 4"),
                            ("s2 s3 s4 other1", "other1 is of another job than s2: its options are PAIRS pairs.tsv --digits 2, not "),
                            ("s1 s2 s3 missing", "missing.oplus-job is missing"),
                            ("s1 s2 s3 s4 -o no/new", "no/new"),
                            ("", "SHARDS is required; see oplus batch merge --help"),
                            ("s1 --digits 3", "merge excludes --digits")]:
            self.assert_refused(f"merge {files}", part)
        self.assert_refused("pairs.tsv merge s1", "merge excludes PAIRS")
        shard, job = self.content("s2"), self.content("s2.oplus-job")
        self.put("s2", shard[:-1])
        self.assert_refused("merge s1 s2 s3 s4", f"s2 is cut or was changed: it has {len(shard) - 1} bytes")
        self.put("s2", b" " * (len(shard) - 1) + b"\n")
        self.assert_refused("merge s1 s2 s3 s4 -o new", "s2 has a line that oplus batch did not write")
        (self.folder / "s2").unlink()
        self.assert_refused("merge s1 s2 s3 s4", "s2 cannot be opened (No such file")
        self.put("s2", shard)
        self.put("s2.oplus-job", re.sub(b',"bytes":[0-9]*', b"", job))
        self.assert_refused("merge s1 s2 s3 s4", "s2 is not complete; its command goes on with --resume")
        # As many bytes, but fewer lines.
        self.compute_all("--parts parts.txt --format area", 4)
        self.put("s2", self.content("s2").replace(b"\n", b" ", 1))
        self.assert_refused("merge s1 s2 s3 s4 -o new", " has more lines than the other shards")


if __name__ == "__main__":
    PROGRAM = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
