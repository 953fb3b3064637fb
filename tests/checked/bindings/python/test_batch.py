# SPDX-License-Identifier: GPL-3.0-or-later
"""Many pairs in a call, and threads."""

import signal
import subprocess
import sys
import threading
import time

import numpy
import pytest

import oplus

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
BOW_TIE = [[0, 0], [2, 2], [2, 0], [0, 2]]


def stars(count, vertices, seed):
    """Arrays of that many stars with integer coordinates, each with the origin inside."""
    numbers = numpy.random.default_rng(seed)
    radii = numbers.integers(400, 1000, size=(count, vertices))
    angles = numpy.arange(vertices) * (2 * numpy.pi / vertices)
    points = numpy.stack([radii * numpy.cos(angles), radii * numpy.sin(angles)], axis=-1)
    return oplus.Arrays(points.round().astype(numpy.int64).reshape(-1, 2),
                        numpy.arange(0, count * vertices + 1, vertices))


def test_ten_thousand_pairs_in_one_call():
    p, q = stars(10000, 6, 1), stars(10000, 5, 2)
    sums = oplus.batch("minkowski_sum", p, q)
    assert len(sums) == 10000
    regions = list(zip(oplus.from_arrays(p), oplus.from_arrays(q)))
    for i in range(0, 10000, 997):
        assert sums[i] == oplus.minkowski_sum(*regions[i])
    assert oplus.to_arrays(sums).regions.shape == (10001,)
    assert oplus.batch("minkowski_sum", p, q, threads=3) == sums


def test_one_region_with_many():
    bin = oplus.Region([[0, 0], [9, 0], [9, 9], [0, 9]])
    parts = oplus.from_arrays(stars(50, 7, 3))
    assert oplus.batch("nfp", bin, parts) == [oplus.nfp(bin, part) for part in parts]
    assert oplus.batch("nfp", parts, bin) == [oplus.nfp(part, bin) for part in parts]
    assert oplus.batch("close", bin, bin) == [oplus.close(bin, bin)]
    assert oplus.batch("ifp", [], bin) == []


def test_boundary():
    assert oplus.batch("minkowski_sum", [SQUARE], [SQUARE], boundary="open") == [
        oplus.minkowski_sum(SQUARE, SQUARE, boundary="open")]
    assert oplus.batch("minkowski_sum", [SQUARE], [SQUARE], boundary="open")[0].boundary == "open"


def test_an_invalid_region_is_named():
    with pytest.raises(oplus.InvalidInput, match=r"^pair 1, q: two edges .* cross"):
        oplus.batch("nfp", [SQUARE] * 4, [SQUARE, BOW_TIE, SQUARE, BOW_TIE])
    arrays = oplus.Arrays(numpy.array(SQUARE + BOW_TIE), [0, 4, 8])
    with pytest.raises(oplus.InvalidInput, match=r"^pair 1, p: two edges .* cross"):
        oplus.batch("nfp", arrays, oplus.Region(SQUARE))
    results = oplus.batch("nfp", arrays, [SQUARE, SQUARE], errors="return")
    assert results[0] == oplus.nfp(SQUARE, SQUARE)
    assert type(results[1]) is oplus.InvalidInput and "pair 1, p" in str(results[1])


@pytest.mark.parametrize("other", [None, {1, 2}, object(), numpy.zeros((3, 2), dtype=bool)], ids=repr)
def test_what_is_no_region_is_named(other):
    with pytest.raises(TypeError, match="^pair 1, p: .*: expected ") as error:
        oplus.batch("nfp", [SQUARE, other, other], oplus.Region(SQUARE))
    first, second = oplus.batch("nfp", [SQUARE] * 2, [other, SQUARE], errors="return")
    assert type(first) is TypeError and str(first) == str(error.value).replace("pair 1, p", "pair 0, q")
    assert second == oplus.nfp(SQUARE, SQUARE)


@pytest.mark.parametrize("arguments, options, wrong", [
    (("add", [SQUARE], [SQUARE]), {}, "operation add; expected sum, nfp,"),
    (("nfp", [SQUARE], [SQUARE] * 2), {}, "p of length 1 and q of length 2; expected as many"),
    (("nfp", [SQUARE], [SQUARE]), {"errors": "ignore"}, "errors ignore; expected raise or return"),
    (("nfp", [SQUARE], [SQUARE]), {"boundary": "half"}, "boundary half; expected closed or open"),
    (("ifp", [SQUARE], [SQUARE]), {"boundary": "open"}, "boundary open of ifp; expected it of sum only"),
    (("nfp", [SQUARE], [SQUARE]), {"threads": 1025}, "threads 1025; expected 0 to 1024"),
    (("nfp", [SQUARE], [SQUARE]), {"threads": -1}, "threads -1; expected 0 to 1024"),
    (("nfp", [SQUARE], [SQUARE]), {"threads": 2**40}, "threads 1099511627776; expected 0 to 1024")])
def test_wrong_arguments(arguments, options, wrong):
    with pytest.raises(ValueError, match=wrong):
        oplus.batch(*arguments, **options)


@pytest.mark.parametrize("operation", [oplus.minkowski_sum, oplus.nfp])
@pytest.mark.parametrize("threads", [1025, -1])
def test_too_many_threads(operation, threads):
    with pytest.raises(ValueError, match=f"threads {threads}; expected 0 to 1024"):
        operation(SQUARE, SQUARE, threads=threads)


# What a program of its own starts with.
PATHS = f"import sys; sys.path[:0] = {sys.path!r}\n"


def run_alone(program):
    return subprocess.run([sys.executable, "-B", "-c", program], capture_output=True, text=True, timeout=60)


def test_a_batch_goes_on_where_no_thread_can_be_started():
    program = (PATHS +
               "import resource, oplus, test_batch\n"
               # Too little for the stacks of a thousand threads.
               "resource.setrlimit(resource.RLIMIT_AS, (2**32, 2**32))\n"
               "print(len(oplus.batch('nfp', test_batch.stars(2000, 5, 8), test_batch.stars(2000, 5, 9), threads=1000)))\n")
    child = run_alone(program)
    assert (child.stdout, child.returncode) == ("2000\n", 0)


def slow_work():
    p, q = stars(1, 1500, 4), stars(1, 700, 5)
    return oplus.from_arrays(p)[0], oplus.from_arrays(q)[0]


@pytest.mark.parametrize("compute", [
    lambda p, q: oplus.minkowski_sum(p, q), lambda p, q: oplus.nfp(p, q),
    lambda p, q: oplus.batch("minkowski_sum", p, [q], threads=1)])
def test_the_lock_is_released(compute):
    p, q = slow_work()
    assert_lock_is_released(lambda: compute(p, q), 0.1)


def assert_lock_is_released(compute, least):
    """Another thread goes on while this one computes: its longest pause is shorter than the computation."""
    longest, is_done = 0, threading.Event()

    def tick():
        nonlocal longest
        last = time.monotonic()
        while not is_done.is_set():
            time.sleep(0.001)
            now = time.monotonic()
            longest, last = max(longest, now - last), now

    ticking = threading.Thread(target=tick)
    ticking.start()
    start = time.monotonic()
    compute()
    took = time.monotonic() - start
    is_done.set()
    ticking.join()
    assert took > least
    assert longest < took / 2


@pytest.mark.parametrize("compute", [oplus.complement, lambda region: region.to_wkt(digits=1)])
def test_the_lock_is_released_by_what_takes_one_region(compute):
    n = 40000
    triangles = numpy.array([[0, 0], [1, 0], [0, 1]]) + 10 * numpy.arange(n)[:, None, None]
    [region] = oplus.from_arrays(oplus.Arrays(triangles.reshape(-1, 2), numpy.arange(0, 3 * n + 1, 3), regions=[0, n]))
    assert_lock_is_released(lambda: compute(region), 0.1)


def test_threads_share_regions():
    p, q = oplus.from_arrays(stars(1, 60, 6))[0], oplus.from_arrays(stars(8, 30, 7))
    found = [None] * len(q)

    def compute(i):
        found[i] = oplus.minkowski_sum(p, q[i])

    threads = [threading.Thread(target=compute, args=[i]) for i in range(len(q))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == oplus.batch("minkowski_sum", p, q, threads=1)


def test_control_c_ends_a_batch():
    program = (PATHS +
               "import signal, oplus, test_batch\n"
               # A shell that starts the tests in the background has it ignored.
               "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
               "p, q = test_batch.slow_work()\n"
               "print('ready', flush=True)\n"
               "try: oplus.batch('minkowski_sum', [p] * 2000, [q] * 2000)\n"
               "except KeyboardInterrupt: print('interrupted')\n")
    with subprocess.Popen([sys.executable, "-B", "-c", program], stdout=subprocess.PIPE, text=True) as child:
        try:
            assert child.stdout.readline() == "ready\n"
            time.sleep(0.3)
            child.send_signal(signal.SIGINT)
            assert child.communicate(timeout=60)[0] == "interrupted\n"
            assert child.returncode == 0
        finally:
            child.kill()


def test_a_batch_on_another_thread_at_exit():
    program = (PATHS +
               "import threading, time, oplus, test_batch\n"
               "p, q = test_batch.stars(10000, 60, 10), test_batch.stars(10000, 60, 11)\n"
               "threading.Thread(target=oplus.batch, args=['nfp', p, q], daemon=True).start()\n"
               "time.sleep(0.3)\n")
    child = run_alone(program)
    assert (child.stderr, child.returncode) == ("", 0)


def test_calls_on_another_thread_at_exit():
    program = (PATHS +
               "import threading, time, oplus, test_batch\n"
               "def work():\n"
               "    while True: oplus.nfp(test_batch.SQUARE, test_batch.SQUARE)\n"
               "threading.Thread(target=work, daemon=True).start()\n"
               "time.sleep(0.3)\n")
    child = run_alone(program)
    assert (child.stderr, child.returncode) == ("", 0)
