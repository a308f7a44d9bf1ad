# SPDX-License-Identifier: BSD-3-Clause
"""tiretherm: the temperature field of a rolling tire, compared with measured data.

>>> import tiretherm as tt
>>> result = tt.Case.from_file("cases/laser/one_watt.toml").run()
>>> print(f"{result.channels['spot_centre_temperature'].to('degC')[-1]:.1f} degC")
99.7 degC
"""

from ._case import Case, Effect
from ._errors import CaseError, Error, Finding, Interrupted, SolverError, Stopped, stop
from ._result import Channel, Comparison, Diagnosis, Fields, Identification, Result, StudyResult, Table, Tire
from ._session import Session
from ._study import Study
from ._tiretherm import version as __version__

__all__ = [
    "Case", "CaseError", "Channel", "Comparison", "Diagnosis", "Effect", "Error", "Fields", "Finding", "Identification",
    "Interrupted", "Result", "Session", "SolverError", "Stopped", "Study", "StudyResult", "Table", "Tire",
    "__version__", "stop",
]  # fmt: skip
