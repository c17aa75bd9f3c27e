"""Long work: other threads go on, signals end it, forks and subinterpreters do no harm, nothing leaks."""

import ctypes
import gc
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import hodt


def test_other_threads_run_meanwhile():
    points, ticks, done = hodt.sample("valley", 200_000), [0], threading.Event()

    def count():
        while not done.is_set():
            ticks[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    before = ticks[0]
    start = time.monotonic()
    hodt.triangulate(points, 4)
    took, counted = time.monotonic() - start, ticks[0] - before
    done.set()
    thread.join()
    assert counted > took * 20


def test_many_threads_at_once():
    sets = [np.random.default_rng(i).random((3000, 3)) for i in range(16)]
    alone = [hodt.triangulate(points, 2).tin for points in sets]
    with ThreadPoolExecutor(8) as pool:
        together = pool.map(lambda points: hodt.triangulate(points, 2, threads=2).tin, sets * 3)
    assert all(a == b for a, b in zip(alone * 3, together))


def interrupt_after(seconds):
    timer = threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    return timer


@pytest.fixture
def ctrl_c_raises():
    """Also where the tests run in the background of a shell, which lets its children ignore it."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize("work", [
    lambda p: hodt.triangulate(p, 40, "min-sum-abn", method="exact"),
    lambda p: hodt.triangulate(p, 2000, "min-local-minima", method="exact"),
    lambda p: hodt.triangulate(p, 30, "min-max-degree", method="exact"),
    lambda p: hodt.triangulate(p, 30, "min-sum-length", method="exact"),
    lambda p: hodt.kod_edges(p, 3000),
    lambda p: hodt.useful_edges(p, 4000),
    lambda p: hodt.kod_triangles(p, 60),
    lambda p: hodt.voronoi(p, 60),
    lambda p: hodt.compare(p, range(0, 900), "min-sum-abn"),
    lambda p: [hodt.delaunay(np.concatenate([p] * 10)) for _ in range(10_000)],
], ids=["abn", "minima", "degree", "length", "kod", "useful", "triangles", "voronoi", "compare",
        "short ones"])
def test_ctrl_c_ends_work_within_a_second(work, ctrl_c_raises):
    points = hodt.sample("valley", 30_000)
    interrupt = interrupt_after(0.7)
    sent = time.monotonic() + 0.7
    with pytest.raises(KeyboardInterrupt):
        work(points)
        interrupt.cancel()
        pytest.skip("done before")
    assert time.monotonic() - sent < 1 + slack()
    interrupt.join()
    assert len(hodt.delaunay(points[:100])) > 100  # and all is well afterwards


def native_handler():
    """Of SIGINT, as the system has it."""
    action = ctypes.create_string_buffer(256)
    assert ctypes.CDLL(None).sigaction(signal.SIGINT, None, action) == 0
    return ctypes.c_void_p.from_buffer(action).value


def test_ctrl_c_stays_python_s_while_programs_are_solved_and_afterwards(ctrl_c_raises):
    before, seen, done = native_handler(), set(), threading.Event()

    def watch():
        while not done.wait(0.0002):
            seen.add(native_handler())

    thread = threading.Thread(target=watch)
    thread.start()
    result = hodt.triangulate(hodt.sample("jacksboro", 3000), 6, "min-sum-length")
    done.set()
    thread.join()
    assert result.value["optimal"]
    assert seen == {before} and native_handler() == before


@pytest.mark.parametrize("after", [0.5, 1, 1.5, 2])
def test_ctrl_c_ends_the_command_while_programs_are_solved(command, tmp_path, after):
    points = tmp_path / "p.csv"
    np.savetxt(points, hodt.sample("valley", 20_000), delimiter=",", fmt="%.17g")
    work = [command, "triangulate", points, "-k", "30", "--objective", "min-sum-length",
            "--method", "exact", "-o", tmp_path / "t.ply"]
    default = lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)  # noqa: E731
    with subprocess.Popen(work, stdout=subprocess.DEVNULL, preexec_fn=default) as run:
        time.sleep(after)
        run.send_signal(signal.SIGINT)
        try:
            assert run.wait(timeout=10) == -signal.SIGINT
        finally:
            run.kill()
    assert not list(tmp_path.glob("t.ply*"))


def slack():
    """What a machine with more to do than processors adds."""
    return 0.5 * os.getloadavg()[0] / (os.cpu_count() or 1)


def test_a_handler_of_signals_is_called_and_may_go_on():
    points, calls = hodt.sample("valley", 300_000), []
    before = signal.signal(signal.SIGALRM, lambda *_: calls.append(time.monotonic()))
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05, 0.05)
        result = hodt.triangulate(points, 4)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert calls and result.order <= 4


def test_progress_is_told_in_the_calling_thread():
    told, thread = [], threading.get_ident()

    def progress(phase, fraction):
        assert threading.get_ident() == thread and (fraction is None or 0 <= fraction <= 1)
        told.append(phase)

    hodt.triangulate(hodt.sample("valley", 20_000), 4, progress=progress)
    assert told[0] == "Delaunay triangulation" and "verification" in told
    told.clear()
    hodt.compare(hodt.sample("valley", 500), 2, progress=progress)
    assert told


def test_errors_of_progress_end_the_work():
    class Enough(Exception):
        pass

    def progress(phase, fraction):
        if phase != "Delaunay triangulation":
            raise Enough(phase)

    start = time.monotonic()
    with pytest.raises(Enough):
        hodt.triangulate(hodt.sample("valley", 30_000), 40, method="exact", progress=progress)
    assert time.monotonic() - start < 30


def test_time_limits():
    start = time.monotonic()
    result = hodt.triangulate(hodt.sample("valley", 20_000), 40, "min-sum-abn", time_limit=0.2)
    assert time.monotonic() - start < 10 and result.value["bound"] <= result.value["result"]


def in_child(points):
    return hodt.triangulate(points, 2).tin.triangles


@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
@pytest.mark.filterwarnings("ignore:.*multi-threaded.*fork:DeprecationWarning")
def test_processes_started_after_threads_computed(method):
    points = hodt.sample("valley", 20_000)
    here = in_child(points)  # the parent has threads now
    with multiprocessing.get_context(method).Pool(2) as pool:
        there = pool.map_async(in_child, [points] * 3).get(timeout=100)
    assert all(np.array_equal(here, t) for t in there)
    assert np.array_equal(here, in_child(points))


def test_a_fork_while_another_thread_computes():
    points = hodt.sample("valley", 100_000)
    with ThreadPoolExecutor(1) as pool:
        busy = pool.submit(hodt.triangulate, points, 8)
        time.sleep(0.05)
        child = os.fork()
        if child == 0:
            status = 1
            try:
                signal.alarm(60)
                status = 0 if len(hodt.delaunay(points)) > 100_000 else 2
            finally:
                os._exit(status)
        assert os.waitpid(child, 0)[1] == 0
        assert busy.result().order <= 8


def test_a_fork_within_a_computation_ends_it_in_the_child():
    points, children = hodt.sample("valley", 20_000), []

    def progress(phase, fraction):
        if not children:
            children.append(os.fork())

    try:
        result = hodt.triangulate(points, 4, progress=progress)
    except RuntimeError as error:  # the child
        signal.alarm(60)
        fine = children == [0] and "forked" in str(error) and len(hodt.delaunay(points)) > 20_000
        os._exit(0 if fine else 1)
    if children == [0]:
        os._exit(2)
    assert os.waitpid(children[0], 0)[1] == 0
    assert result.order <= 4


@pytest.mark.parametrize("work", [
    "hodt.triangulate(points, 4)",
    "hodt.delaunay(points[:100])",
    "hodt.triangulate(points, 4, progress=lambda *_: None)",
    "hodt.triangulate(points[:300], 2, hodt.Measure(lambda a, b, c: numpy.ones(len(a))))",
    "hodt.triangulate(points, 40, 'min-sum-abn', method='exact')",
], ids=["triangulate", "short", "progress", "measure", "long"])
def test_python_ends_while_other_threads_compute(work):
    program = f"""
import hodt, numpy, threading, time
points = hodt.sample("valley", 3000)
def compute():
    while True:
        {work}
for _ in range(3):
    threading.Thread(target=compute, daemon=True).start()
time.sleep(0.2)
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
    assert (run.returncode, run.stderr) == (0, "")


def test_functions_called_at_the_end_may_compute():
    program = """
import atexit
@atexit.register
def last():
    points = hodt.sample("valley", 3000)
    print(hodt.triangulate(points, 2).order <= 2)
import hodt
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
    assert (run.returncode, run.stdout, run.stderr) == (0, "True\n", "")


def test_subinterpreters_get_an_answer_or_an_error():
    program = """
try:
    import _interpreters as interpreters
except ImportError:
    import _xxsubinterpreters as interpreters
import hodt, sys
other = interpreters.create()
code = '''
try:
    import hodt
    assert len(hodt.delaunay([[0, 0], [1, 0], [0, 1]])) == 1
except ImportError as error:
    print("refused:", error)
else:
    print("works")
'''
try:
    problem = (interpreters.run_string if hasattr(interpreters, "run_string") else interpreters.exec)(other, code)
    print("told:", problem) if problem else None
except Exception as error:
    print("refused:", error)
print("first:", len(hodt.delaunay([[0, 0], [1, 0], [0, 1]])))
sys.stdout.flush()
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
    assert run.returncode == 0, run.stderr
    assert any(word in run.stdout for word in ("refused", "works", "told"))
    assert "first: 1" in run.stdout


def resident():
    with open("/proc/self/statm") as statm:
        return int(statm.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.parametrize("work", [
    lambda p: hodt.delaunay(p),
    lambda p: hodt.Delaunay(p).find_simplex(p[:, :2]),
    lambda p: hodt.triangulate(p, 2),
    lambda p: hodt.useful_edges(p, 2),
    lambda p: hodt.triangulate(p, 1, objective="none").tin.interpolate(p[:, :2]),
    lambda p: hodt.triangulate(p[:50], 1, hodt.Measure(lambda a, b, c: np.ones(len(a)))),
    lambda p: hodt.voronoi(p, 2),
    lambda p: pytest.raises(hodt.InputError, hodt.delaunay, p * np.nan),
    lambda p: hodt.triangulate(p, 1, progress=lambda *_: None),
], ids=["delaunay", "Delaunay", "triangulate", "edges", "interpolate", "measure", "voronoi", "errors",
        "progress"])
def test_a_thousand_calls_leak_nothing(work):
    points = np.random.default_rng(1).random((400, 3))

    def calls(n):
        for _ in range(n):
            work(points)
        gc.collect()

    calls(20)  # each makes 10 kB or more
    references, before = sys.getrefcount(points), resident()
    calls(1000)
    assert sys.getrefcount(points) == references
    assert resident() - before < 2 << 20


def test_many_calls_leak_nothing():
    points = np.random.default_rng(1).random((60, 3))

    def calls(n):
        for _ in range(n):
            hodt.triangulate(points, 1)

    calls(20)
    before = resident()
    calls(15_000)
    assert resident() - before < 2 << 20


def test_threads_that_come_and_go_leave_nothing():
    points = np.random.default_rng(1).random((400, 3))

    def calls(n):
        for _ in range(n):
            thread = threading.Thread(target=hodt.triangulate, args=(points, 2))
            thread.start()
            thread.join()

    calls(20)
    before, threads = resident(), len(os.listdir("/proc/self/task"))
    calls(300)
    assert resident() - before < 2 << 20
    assert len(os.listdir("/proc/self/task")) < threads + 10  # some are on their way out


def test_signals_are_left_to_other_threads():
    program = """
import hodt, numpy, os, signal
points = numpy.random.default_rng(1).random((20_000, 3))
before = set(os.listdir("/proc/self/task"))
hodt.triangulate(points, 2)
for task in set(os.listdir("/proc/self/task")) - before:
    with open(f"/proc/self/task/{task}/status") as status:
        blocked = next(int(line.split()[1], 16) for line in status if line.startswith("SigBlk"))
    print(*(bool(blocked >> s - 1 & 1) for s in (signal.SIGINT, signal.SIGUSR1, signal.SIGSEGV)))
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
    assert run.returncode == 0, run.stderr
    assert set(run.stdout.splitlines()) == {"True True False"}


def test_importing_twice_and_exiting_early():
    program = "import hodt, importlib, numpy; importlib.reload(hodt); " \
              "hodt.triangulate(numpy.random.rand(5000, 3), 2); raise SystemExit(3)"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
    assert run.returncode == 3 and run.stderr == ""
