# SPDX-License-Identifier: BSD-3-Clause
"""Comparison, fit, diagnosis, study and session from Python; threads, progress and Ctrl-C."""

import json
import os
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy as np
import tiretherm as tt

TWO_NODES = "cases/two_node/4000N_100kmh.toml"
BENCH = "cases/practice/two_node_bench.toml"
PUZZLES = [f"cases/practice/puzzle{i}.csv" for i in (1, 2, 3)]


def interrupt_after(seconds):
    timer = threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    return timer


def long_case():
    """So many steps that no machine is done in a second."""
    case = tt.Case.from_file(TWO_NODES)
    case["time.end"] = "4000 h"
    case["time.step"] = "1 s"
    return case


class Beside:
    """A long run in a thread of its own; what ended it is in `stopped`."""

    def __init__(self):
        self.stopped = []
        self.thread = threading.Thread(target=self._work)
        self.thread.start()

    def _work(self):
        try:
            long_case().run()
        except tt.Stopped as error:
            self.stopped.append(error)


class Measured(unittest.TestCase):
    def test_fit_has_the_programs_data(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [os.environ["TIRETHERM_PROGRAM"], "identify", BENCH, "--data", PUZZLES[0], "--json", "--out", folder],
                check=False, capture_output=True, text=True,
            )  # fmt: skip
            expected = json.loads(done.stdout)
        fit = tt.Case.from_file(BENCH).identify(PUZZLES[0])
        self.assertTrue(fit.has_converged)
        self.assertEqual(fit.summary["parameters"], expected["parameters"])
        self.assertIn("identify", fit.tables)
        self.assertGreater(tt.Case.from_file(fit.case_file).compare(PUZZLES[0]).summary["channels"][0]["samples"], 0)

    # Columns are written with all digits, so that they are the file's.
    def test_compares_with_columns_as_with_their_file(self):
        of_file = tt.Case.from_file(BENCH).compare(PUZZLES[0])
        of_columns = tt.Case.from_file(BENCH).compare(dict(tt.Table(Path(PUZZLES[0]))))
        self.assertIn("compare", of_file.tables)
        of_columns, of_file = of_columns.tables["compare"], of_file.tables["compare"]
        numbers = [head for head in of_file if of_file[head].dtype == float]
        self.assertGreater(len(numbers), 2)
        for head in numbers:
            np.testing.assert_array_equal(of_columns[head], of_file[head])

    def test_results_of_one_case_keep_their_files_apart(self):
        case = tt.Case.from_file(BENCH)
        first, second = case.compare(PUZZLES[0]), case.compare(PUZZLES[1])
        self.assertNotEqual(first.folder, second.folder)
        self.assertTrue(first.folder.is_dir())
        folder = first.folder
        del first
        self.assertFalse(folder.exists())

    def test_diagnosis_within_a_time_limit(self):
        diagnosis = tt.Case.from_file(BENCH).diagnose(PUZZLES[0], time_limit=60, by_run=False)
        self.assertIn("verdict", diagnosis.summary)
        self.assertIn("residuals", diagnosis.tables)

    def test_case_without_data_is_an_error_with_its_remedy(self):
        with self.assertRaises(tt.CaseError) as raised:
            tt.Case.from_file(TWO_NODES).identify()
        self.assertTrue(raised.exception.findings)
        with self.assertRaises(tt.CaseError) as raised:
            tt.Case.from_file(BENCH).compare("no_such_file.csv")
        self.assertIn("no_such_file.csv", str(raised.exception))


class Studies(unittest.TestCase):
    def test_rows_are_those_of_single_runs(self):
        case = tt.Case.from_file(TWO_NODES)
        rows = tt.Study(case, vary={"drive.speed": ["80 km/h", "120 km/h"]}).run().tables["study"]
        case["drive.speed"] = "120 km/h"
        hottest = case.run().hottest["temperature"] - 273.15
        self.assertEqual(len(rows["run"]), 2)
        heads = [head for head in rows if "hottest" in head]
        self.assertTrue(any(abs(float(rows[head][1]) - hottest) < 0.01 for head in heads), (heads, hottest))

    def test_wrong_key_is_an_error(self):
        with self.assertRaises(tt.CaseError):
            tt.Study(tt.Case.from_file(TWO_NODES), vary={"drive.sped": ["80 km/h"]}).run()


class Interruption(unittest.TestCase):
    def test_ctrl_c_keeps_the_rows_and_the_next_run_is_whole(self):
        timer = interrupt_after(0.5)
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt) as raised:
            long_case().run()
        timer.join()
        self.assertLess(time.monotonic() - begin, 20)
        result = raised.exception.result
        self.assertTrue(result.is_stopped)
        self.assertGreater(result.time[-1], 0)
        self.assertGreater(len(result.channels["bulk_temperature"]), 1)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
        self.assertFalse(tt.Case.from_file(TWO_NODES).run().is_stopped)

    # A call of another thread is under way all the time: what ended the first call ends neither that nor the next one.
    def test_ctrl_c_ends_the_call_of_the_main_thread_alone(self):
        beside = Beside()
        timer = interrupt_after(0.5)
        with self.assertRaises(tt.Interrupted):
            long_case().run()
        timer.join()
        self.assertFalse(tt.Case.from_file(TWO_NODES).run().is_stopped)
        self.assertTrue(beside.thread.is_alive())
        tt.stop()
        beside.thread.join(30)
        self.assertEqual(len(beside.stopped), 1)
        self.assertFalse(tt.Case.from_file(TWO_NODES).run().is_stopped)

    # A limit that has passed before there is an answer: the run beside it goes on.
    def test_time_limit_is_of_one_diagnosis(self):
        beside = Beside()
        with self.assertRaisesRegex(tt.SolverError, "time limit"):
            tt.Case.from_file(BENCH).diagnose(PUZZLES, time_limit=1e-3)
        self.assertTrue(beside.thread.is_alive())
        tt.stop()
        beside.thread.join(30)
        self.assertEqual(len(beside.stopped), 1)

    # What was simulated is kept with the case, from where the same call goes on.
    def test_ctrl_c_keeps_the_simulations_of_a_diagnosis(self):
        case = tt.Case.from_file("cases/practice/section_bench.toml")
        timer = interrupt_after(2.0)
        with self.assertRaises(tt.Interrupted) as raised:
            case.diagnose("cases/practice/section_run1.csv", by_run=False)
        timer.join()
        if raised.exception.result is None:
            self.assertTrue((case._folders["diagnose"].path / ".tiretherm/diagnose.simulations").is_file(), raised.exception)

    def test_stop_ends_a_run_of_another_thread(self):
        beside = Beside()
        time.sleep(0.5)
        tt.stop()
        beside.thread.join(30)
        self.assertEqual(len(beside.stopped), 1)
        self.assertTrue(beside.stopped[0].result.is_stopped)

    def test_threads_give_the_same_numbers_side_by_side(self):
        alone = tt.Case.from_file(TWO_NODES).run()
        results = [None] * 4

        def work(i):
            results[i] = tt.Case.from_file(TWO_NODES).run()

        threads = [threading.Thread(target=work, args=(i,)) for i in range(len(results))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for result in results:
            np.testing.assert_array_equal(result.channels["bulk_temperature"].values, alone.channels["bulk_temperature"].values)

    def test_progress_is_told(self):
        lines = []

        def tell(line):
            lines.append(line)
            if len(lines) == 2:
                os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(tt.Interrupted):
            long_case().run(progress=tell)
        self.assertIn("%", lines[0])

    def test_what_progress_raises_comes_out(self):
        def tell(line):
            raise LookupError(line)

        with self.assertRaises(LookupError):
            long_case().run(progress=tell)


class Sessions(unittest.TestCase):
    # At the case's own inputs the tire tends to the end of the run.
    def test_settles_where_the_run_does(self):
        case = tt.Case.from_file(TWO_NODES)
        tire = tt.Session(case)
        tire.step(10.0, count=360)
        self.assertAlmostEqual(tire.time, 3600)
        self.assertAlmostEqual(tire["bulk_temperature"], case.run().channels["bulk_temperature"][-1], delta=0.2)

    def test_wrong_inputs_are_errors(self):
        tire = tt.Session(TWO_NODES)
        for inputs in ({"sped": 3.0}, {"speed": -1e9}):
            with self.assertRaises(ValueError):
                tire.step(0.1, inputs)
        with self.assertRaises(ValueError):
            tire.step(-1.0)
        self.assertEqual(tire.time, 0)
        with self.assertRaises(tt.CaseError):
            tt.Session(tt.Case.from_text("[drive]"))

    def test_channels_are_one_array(self):
        tire = tt.Session(TWO_NODES)
        first = tire.step(0.1)
        self.assertIs(tire.step(0.1), first)
        self.assertEqual(len(tire.temperature.shape), 1)

    def test_overhead_is_told(self):
        n, tire, inputs = 20000, tt.Session(TWO_NODES), {"speed": 30.0, "vertical_load": 4000.0}
        tire.step(0.001, inputs, count=n)
        times = {}
        for name, work in {
            "in C++": lambda: tire.step(0.001, count=n),
            "from Python": lambda: [tire.step(0.001) for _ in range(n)],
            "from Python with two inputs": lambda: [tire.step(0.001, inputs) for _ in range(n)],
        }.items():
            begin = time.perf_counter()
            work()
            times[name] = 1e6 * (time.perf_counter() - begin) / n
        print("Session.step:", ", ".join(f"{microseconds:.2f} us {name}" for name, microseconds in times.items()))


if __name__ == "__main__":
    unittest.main()
