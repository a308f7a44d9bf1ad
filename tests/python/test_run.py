# SPDX-License-Identifier: BSD-3-Clause
"""Runs from Python: the program's numbers, views of arrays, errors with their places."""

import json
import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np
import tiretherm as tt

TWO_NODES = "cases/two_node/4000N_100kmh.toml"
PROGRAM = os.environ["TIRETHERM_PROGRAM"]


def program(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], check=False, capture_output=True, text=True)


class Run(unittest.TestCase):
    # Both come from the same libraries, so that each digit of JSON, which has all of them, is the same.
    def test_has_the_programs_numbers_to_the_last_bit(self):
        with tempfile.TemporaryDirectory() as folder:
            done = program("run", TWO_NODES, "--json", "--out", folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            expected = json.loads(done.stdout)
        result = tt.Case.from_file(TWO_NODES).run()
        # Wall times and the paths of files are no results.
        for key in ("case", "cells", "steps", "energy_closure", "channels", "budget", "hottest"):
            self.assertEqual(result.summary[key], expected[key], key)

    # channels.mat has the numbers that pages show, each in eight bytes, a channel after the other.
    def test_rows_are_those_of_the_program_to_the_last_bit(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(program("run", TWO_NODES, "--mat", "--quiet", "--out", folder).returncode, 0)
            written = (Path(folder) / "channels.mat").read_bytes()
        result = tt.Case.from_file(TWO_NODES).run()
        self.assertTrue(result.time.tobytes() in written)
        for name, channel in result.channels.items():
            self.assertTrue((channel.values - 273.15).tobytes() in written, name)

    def test_files_are_written_where_they_are_asked_for(self):
        with tempfile.TemporaryDirectory() as folder:
            in_files = tt.Case.from_file(TWO_NODES).run(out=folder)
            self.assertTrue((Path(folder) / "report.html").is_file())
            self.assertTrue((Path(folder) / "results.h5").is_file())
        in_memory = tt.Case.from_file(TWO_NODES).run()
        self.assertGreater(len(in_memory.time), 10)
        np.testing.assert_array_equal(in_memory.time, in_files.time)
        for name, channel in in_memory.channels.items():
            np.testing.assert_array_equal(channel.values, in_files.channels[name].values)

    def test_arrays_are_views_that_outlive_the_result(self):
        values = tt.Case.from_file(TWO_NODES).run().channels["bulk_temperature"].values
        self.assertFalse(values.flags.owndata)
        self.assertFalse(values.flags.writeable)
        self.assertTrue(np.all((values > 273) & (values < 400)))

    # The heat of all effects is what is stored: the first law.
    def test_budget_closes(self):
        result = tt.Case.from_file(TWO_NODES).run()
        into = sum(heat.values for name, heat in result.heat.items() if name != "stored")
        np.testing.assert_allclose(into, result.heat["stored"].values, rtol=0, atol=1e-6 * np.max(np.abs(into)) + 1e-9)

    # The last field is the last row: a two-node model's channels are its nodes.
    def test_fields_have_the_last_moment(self):
        result = tt.Case.from_file(TWO_NODES).run()
        self.assertEqual(result.fields.time[-1], result.time[-1])
        self.assertEqual(result.fields.temperature.shape, (len(result.fields), len(result.fields.mesh["volume"])))
        last = [result.channels[name].values[-1] for name in ("surface_temperature", "bulk_temperature")]
        for value in last:
            self.assertTrue(np.any(np.isclose(result.fields.temperature[-1], value, rtol=0, atol=1e-9)), value)

    def test_units_are_converted(self):
        channel = tt.Case.from_file(TWO_NODES).run().channels["bulk_temperature"]
        self.assertEqual((channel.unit, channel.shown_unit), ("K", "degC"))
        np.testing.assert_allclose(channel.to(), channel.values - 273.15, rtol=0, atol=1e-9)
        with self.assertRaises(ValueError):
            channel.to("m/s")

    def test_a_sensor_in_python_is_a_channel(self):
        means = tt.Case.from_file(TWO_NODES).run(sensors={"mean": lambda time, temperature: float(temperature.mean())})
        self.assertEqual(len(means.channels["mean"]), len(means.time))
        self.assertEqual(means.channels["mean"][-1], means.fields.temperature[-1].mean())

    def test_what_a_sensor_raises_comes_out(self):
        with self.assertRaises(ZeroDivisionError):
            tt.Case.from_file(TWO_NODES).run(sensors={"bad": lambda time, temperature: 1 / 0})

    def test_a_car_has_four_tires(self):
        result = tt.Case.from_file("cases/car/session.toml").run()
        self.assertEqual(list(result.tires), ["FL", "FR", "RL", "RR"])
        self.assertEqual(len(result.summary["corners"]), 4)
        self.assertNotEqual(result.tires["FL"].hottest["temperature"], result.tires["FR"].hottest["temperature"])

    def test_page_opens_in_a_notebook(self):
        page = tt.Case.from_file(TWO_NODES).run()._repr_html_()
        self.assertTrue(page.startswith("<iframe"))
        self.assertIn("&lt;!DOCTYPE html&gt;", page[:2000].replace("doctype", "DOCTYPE"))

    def test_says_which_package_is_missing(self):
        result = tt.Case.from_file(TWO_NODES).run()
        for package, call in (("pandas", result.to_pandas), ("xarray", result.to_xarray), ("matplotlib", result.plot)):
            try:
                call()
            except ImportError as error:
                self.assertIn(package, str(error))


class Effects(unittest.TestCase):
    """Laws in Python: 0.8 W/K from the bulk to air of 23 degC, as an [[exchange]] of the case has it."""

    WALL = """
        [[exchange]]
        name = "wall"
        at = "bulk"
        conductance = "0.8 W/K"
        temperature = "23 degC"
    """

    @staticmethod
    def case(more=""):
        case = tt.Case.from_text(f'include = ["{Path(TWO_NODES).absolute()}"]\n{more}')
        case["time.step"] = "5 s"
        return case

    # Of equal steps each is solved to some 1e-9 K, whoever computes the heat.
    def test_law_equals_that_of_the_case(self):
        expected = self.case(self.WALL).run()
        laws = {
            "with its derivative": lambda signal, T: (0.8 * (296.15 - T), np.full_like(T, -0.8)),
            "without": lambda signal, T: 0.8 * (296.15 - T),
        }
        for name, law in laws.items():
            with self.subTest(name):
                result = self.case().run(effects={"wall": tt.Effect(law, at="bulk")})
                for channel in ("surface_temperature", "bulk_temperature"):
                    np.testing.assert_allclose(
                        result.channels[channel], expected.channels[channel].values, rtol=0, atol=1e-7
                    )
                np.testing.assert_allclose(result.budget["wall"], expected.budget["wall"].values, rtol=0, atol=1e-6)
                self.assertLess(result.summary["energy_closure"], 1e-10)

    # 4 kN at 100 km/h for an hour: the signal is in SI units.
    def test_law_has_the_signal_that_it_follows(self):
        seen = set()

        def law(signal, T):
            seen.add((round(signal, 6), T.shape))
            return 1e-3 * signal

        result = self.case().run(effects={"rolling": tt.Effect(law, at="bulk", follows="speed * vertical_load")})
        self.assertEqual(seen, {(round(4000 * 100 / 3.6, 6), (1,))})
        self.assertAlmostEqual(result.budget["rolling"][-1], 4000 / 3.6 * 0.1, places=9)

    # Nodes share a layer by heat capacity and a surface by area: whatever they are, their sum is the whole.
    def test_nodes_share_the_heat(self):
        case = tt.Case.from_file("cases/section/4000N_100kmh.toml")
        case["time.end"] = "60 s"
        result = case.run(effects={"belt": tt.Effect(lambda signal, T: 10.0, at="tread")})
        self.assertAlmostEqual(result.budget["belt"][-1], 10.0, places=9)

    def test_what_a_law_raises_comes_out(self):
        with self.assertRaises(ZeroDivisionError):
            self.case().run(effects={"bad": tt.Effect(lambda signal, T: 1 / 0, at="bulk")})
        with self.assertRaisesRegex(ValueError, "bad gives 3 values; its place has 1 node"):
            self.case().run(effects={"bad": tt.Effect(lambda signal, T: np.zeros(3), at="bulk")})
        with self.assertRaisesRegex(ValueError, "bad gives no numbers"):
            self.case().run(effects={"bad": tt.Effect(lambda signal, T: "hot", at="bulk")})
        with self.assertRaises(tt.SolverError):
            self.case().run(effects={"bad": tt.Effect(lambda signal, T: float("nan"), at="bulk")})

    def test_wrong_place_is_said_at_the_users_line(self):
        with self.assertRaises(tt.CaseError) as raised:
            self.case().run(effects={"bad": tt.Effect(lambda signal, T: 0.0, at="bulks")})
        (finding,) = raised.exception.findings
        self.assertEqual(Path(finding.file).name, Path(__file__).name)
        self.assertIn("bulks", finding.message)

    def test_cost_is_told(self):
        calls = 0

        def law(signal, T):
            nonlocal calls
            calls += 1
            return 0.8 * (296.15 - T), np.full_like(T, -0.8)

        seconds = {}
        for name, run in {
            "of the case": lambda: self.case(self.WALL).run(),
            "in Python": lambda: self.case().run(effects={"wall": tt.Effect(law, at="bulk")}),
        }.items():
            begin = time.perf_counter()
            run()
            seconds[name] = time.perf_counter() - begin
        print("An effect:", ", ".join(f"{1e3 * s:.1f} ms {name}" for name, s in seconds.items()), f"with {calls} calls")


class Values(unittest.TestCase):
    def test_set_value_is_that_of_a_changed_file(self):
        case = tt.Case.from_file(TWO_NODES)
        case["drive.speed"] = "120 km/h"
        text = Path(case.path).read_text()
        self.assertIn('"drive.speed" = "120 km/h"', text)
        hot = case.run().hottest["temperature"]
        self.assertGreater(hot, tt.Case.from_file(TWO_NODES).run().hottest["temperature"])
        self.assertEqual(case["drive.speed"], "120 km/h")
        self.assertEqual(case.run().summary["case"], tt.Case.from_file(TWO_NODES).run().summary["case"])

    def test_wrong_unit_is_said_at_the_users_line_with_its_remedy(self):
        case = tt.Case.from_file(TWO_NODES)
        case["drive.speed"] = "120 kg"  # this line
        here = next(i for i, line in enumerate(Path(__file__).read_text().splitlines(), 1) if line.endswith("# this line"))
        with self.assertRaises(tt.CaseError) as raised:
            case.run()
        (finding,) = raised.exception.findings
        self.assertEqual((Path(finding.file).name, finding.line), (Path(__file__).name, here))
        self.assertIn("120 kg", finding.message)
        self.assertTrue(finding.remedy)

    def test_wrong_key_is_said_with_what_is_near(self):
        case = tt.Case.from_file(TWO_NODES)
        case["drive.sped"] = "120 km/h"
        with self.assertRaises(tt.CaseError) as raised:
            case.check()
        self.assertEqual(raised.exception.findings[0].remedy, "did you mean `speed`?")
        with self.assertRaisesRegex(KeyError, "drive.speed"):
            tt.Case.from_file(TWO_NODES)["drive.sped"]

    def test_error_in_a_file_has_its_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "wrong.toml"
            path.write_text(f'include = ["{Path(TWO_NODES).absolute()}"]\n[drive]\nspeed = "fast"\n')
            with self.assertRaises(tt.CaseError) as raised:
                tt.Case.from_file(path).run()
        self.assertEqual((raised.exception.findings[0].file, raised.exception.findings[0].line), (str(path), 3))

    def test_text_is_a_case(self):
        text = f'include = ["{Path(TWO_NODES).absolute()}"]\ntitle = "From a text"\n'
        self.assertEqual(tt.Case.from_text(text)["title"], "From a text")
        self.assertGreater(tt.Case.from_text(text).copy().run().hottest["temperature"], 300)
        with self.assertRaises(tt.CaseError):
            tt.Case.from_text("[drive").run()

    # 1e300 W in the surface: no step can be made.
    def test_failed_run_says_why_and_has_its_rows(self):
        text = f'''include = ["{Path(TWO_NODES).absolute()}"]
            [[source]]
            name = "s"
            at = "surface"
            watts = "1 W"
            follows = "1e300"'''
        with self.assertRaises(tt.SolverError) as raised:
            tt.Case.from_text(text).run()
        self.assertTrue(str(raised.exception))
        self.assertGreaterEqual(len(raised.exception.result.time), 1)

    def test_temperature_of_no_tire_is_refused(self):
        case = tt.Case.from_file(TWO_NODES)
        case["initial.temperature"] = "1e300 K"
        with self.assertRaises(tt.CaseError):
            case.run()


if __name__ == "__main__":
    unittest.main()
