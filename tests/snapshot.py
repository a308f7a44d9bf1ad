#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# While the reading and the writing are rebuilt, what all commands say must stay as it is: the JSON (or the text, where
# there is none) of calls over the case library, with times masked. To be tried on the machine that took it: the last
# digits of a fit differ from processor to processor. Removed when the rebuilding is done.
# usage: snapshot.py ROOT PROGRAM            compares with tests/snapshot.json.xz; prints what differs, exit 1
#        snapshot.py ROOT PROGRAM --take     writes it
import difflib
import glob
import json
import lzma
import os
import re
import subprocess
import sys
import tempfile

root, program = sys.argv[1], os.path.abspath(sys.argv[2])
os.chdir(root)
kept_file = "tests/snapshot.json.xz"

cases = sorted(c for c in glob.glob("cases/*/*.toml") if not c.endswith("_common.toml"))
logs = sorted(glob.glob("cases/*/*.csv"))
ran = ["two_node/7500N_150kmh", "layers/one_rubber", "durability/un_r30_load_speed", "laser/one_watt",
       "rotation/averaged", "section/4000N_100kmh", "car/wheels"]
calls = [["check", c, "--json"] for c in cases]
calls += [["check", l, "--json"] for l in logs]
calls += [["new", l, "--json", "--out", "TMP/" + l.replace("/", "_") + ".toml"] for l in logs]
calls += [["new", s, "--out", "TMP/size.toml", "--force"] for s in ("225/50 R17", "205/55 R16 91V", "11x7.1-5", "11R22.5")]
calls += [["run", f"cases/{c}.toml", "--json", "--no-report", "--out", "TMP/run"] for c in ran if os.path.exists(f"cases/{c}.toml")]
calls += [[command, "cases/practice/two_node_bench.toml", "--json", "--no-report", "--out", "TMP/fit"]
          for command in ("compare", "identify", "diagnose")]
calls += [["compare", "cases/car/wheels.toml", "--json", "--no-report", "--out", "TMP/car"]]
calls += [["study", "cases/studies/speed_and_load_two_node.toml", "--json", "--no-report", "--out", "TMP/study"]]
calls += [["effects", "--json"], ["inputs", "--json"], ["keys", "--markdown"]]


def masked(text, folder):
    text = text.replace(folder, "TMP").replace(os.getcwd(), "ROOT")
    text = re.sub(r'("(?:[a-z_]*seconds|assembly|factor|solve|output|version|commit|build|date|started|host|time_of_[a-z]*|wall_[a-z]*)"\s*:\s*)("[^"]*"|[-\d.e+]+)', r"\1MASKED", text)
    return re.sub(r"\b\d+(\.\d+)? (s|ms|min)( of CPU)?\b(?= (on|with) \d+ (core|thread))", "MASKED", text)


def said(call, folder):
    done = subprocess.run([program, *(w.replace("TMP", folder) for w in call)], capture_output=True, text=True, timeout=900)
    files = [f for f in call if f.startswith("TMP/") and f.endswith(".toml")]
    made = "".join(open(f.replace("TMP", folder)).read() for f in files if os.path.exists(f.replace("TMP", folder)))
    return masked(f"exit {done.returncode}\n{done.stdout}{done.stderr}{made}", folder)


with tempfile.TemporaryDirectory() as folder:
    now = {" ".join(call): said(call, folder) for call in calls}
if "--take" in sys.argv:
    lzma.open(kept_file, "wt").write(json.dumps(now, indent=0))
    sys.exit(0)
kept = json.load(lzma.open(kept_file, "rt"))
wrong = [call for call in sorted(set(now) | set(kept)) if now.get(call) != kept.get(call)]
for call in wrong:
    print(f"tiretherm {call}")
    print("\n".join(list(difflib.unified_diff(kept.get(call, "").splitlines(), now.get(call, "").splitlines(), lineterm="", n=1))[:40]))
sys.exit(1 if wrong else 0)
