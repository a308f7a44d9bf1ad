# SPDX-License-Identifier: BSD-3-Clause
"""Builds the extension module with CMake, in build/python of the source, where a second build takes what the first has made."""

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
        build = ROOT / "build" / "python"
        subprocess.check_call(["cmake", "--preset", "python", f"-DPython3_EXECUTABLE={sys.executable}"], cwd=ROOT)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.check_call(["cmake", "--build", str(build), "--target", "tiretherm_package", "-j", jobs], cwd=ROOT)
        target = Path(self.get_ext_fullpath(ext.name)).parent
        target.mkdir(parents=True, exist_ok=True)
        for library in (build / "package" / "tiretherm").glob("*.so"):
            shutil.copy2(library, target)


setup(version=version(), ext_modules=[Extension("tiretherm._tiretherm", [])], cmdclass={"build_ext": CMakeBuild})
