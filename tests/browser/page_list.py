# SPDX-License-Identifier: BSD-3-Clause
"""The kinds of pages, and how one of each is made."""
import concurrent.futures
import os
import shlex
import subprocess

BENCH = "cases/practice/two_node_bench.toml --data cases/practice/puzzle1.csv --data cases/practice/puzzle2.csv"
PAGES = {  # what the page shows: the call that writes it, behind those that it needs
    "run of two nodes": "run cases/two_node/4000N_100kmh.toml",
    "run with laws of the tire": "run cases/handling/tire_laws.toml",
    "run of a section": "run cases/section/4000N_100kmh.toml",
    "run with hot spots": "run cases/durability/sae_j1561_step_speed.toml",
    "run of a car": "run cases/car/session.toml",
    "run of a specimen": "run cases/laser/one_watt.toml",
    "run of a ring": "run cases/rotation/ring.toml",
    "two results": "run cases/two_node/4000N_100kmh.toml --out {out}/a && run cases/two_node/7000N_100kmh.toml --out {out}/b"
                   " && report {out}/a {out}/b",
    "compare": f"compare {BENCH}",
    "compare with a camera": "compare cases/laser/imaging/imaging.toml",
    "compare four tires": "compare cases/car/session.toml",
    "identify": f"identify {BENCH}",
    "identify laws": "identify cases/laser/identify.toml",
    "identify a plan": "identify cases/laser/identify.toml --plan",
    "diagnose": f"diagnose {BENCH}",
    "diagnose a table": "diagnose tests/browser/quoted.toml",
    "study as a map": "study cases/studies/speed_and_load_two_node.toml",
    "study of samples over speed": "study cases/studies/uncertain_two_node.toml",
    "study of samples": "study tests/browser/samples.toml",
    "validate": "validate --only M7,M8",
}


class PageError(Exception):
    """A call failed; what it said."""


def make_page(root, program, folder, name):
    """The path of report.html. @errors PageError"""
    out = folder / name.replace(" ", "_")
    *before, last = PAGES[name].replace("{out}", str(out)).split(" && ")
    for words in (*before, f"{last} --out {out}"):
        call = [str(program), *shlex.split(words)]
        done = subprocess.run(call, cwd=root, capture_output=True, text=True, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
        if done.returncode != 0:
            raise PageError(f"{shlex.join(call)} failed:\n{done.stdout[-500:]}{done.stderr}")
    return out / "report.html"


def make_pages(root, program, folder, names=None):
    """(name, path) of each page, as soon as it is there: the next ones are made meanwhile."""
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        made = {name: pool.submit(make_page, root, program, folder, name) for name in names or PAGES}
        try:
            for name, page in made.items():
                yield name, page.result()
        finally:
            pool.shutdown(cancel_futures=True)
