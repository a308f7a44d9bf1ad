# SPDX-License-Identifier: BSD-3-Clause
"""Builds the extension module with CMake, in build/release of the source, where it takes what ./run or an earlier build has made."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent.parent


def version() -> str:
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"project\(tiretherm VERSION ([0-9.]+)", text)
    assert found, "CMakeLists.txt names no version"
    return found.group(1)


class CMakeBuild(build_ext):
    def build_extension(self, ext: Extension) -> None:
        build = ROOT / "build" / "release"
        interpreter = Path(sys.executable).resolve()  # of a virtual environment, which may go
        subprocess.check_call(["cmake", "--preset", "release", f"-DPython3_EXECUTABLE={interpreter}"], cwd=ROOT)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.check_call(["cmake", "--build", str(build), "--target", "tiretherm_package", "-j", jobs], cwd=ROOT)
        target = Path(self.get_ext_fullpath(ext.name)).parent
        target.mkdir(parents=True, exist_ok=True)
        for library in (build / "package" / "tiretherm").glob("*.so"):
            shutil.copy2(library, target)


setup(version=version(), ext_modules=[Extension("tiretherm._tiretherm", [])], cmdclass={"build_ext": CMakeBuild})
