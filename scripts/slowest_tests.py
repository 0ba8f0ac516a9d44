"""Print how long each part of the tests took, and the slowest tests.

    slowest_tests.py FOLDER

The folder has the parts' times (`times`: part, seconds, processor seconds in user and system mode) and the
reports of ctest and pytest in JUnit's format (`*.xml`); scripts/test leaves both there.
"""

import sys
from pathlib import Path
from xml.etree import ElementTree

COUNT = 10


def parts(file):
    """Yield part, seconds and processor seconds."""
    for line in file.read_text(encoding="utf-8").splitlines():
        part, seconds, user, system = line.split(";")
        yield part, float(seconds), float(user) + float(system)


def tests(report):
    """Yield seconds and name of each test of a report."""
    for case in ElementTree.parse(report).iter("testcase"):
        file = case.get("classname", "").rpartition(".")[2]
        name = f"{file}::{case.get('name')}" if report.stem == "python" else case.get("name")
        yield float(case.get("time", 0.0)), f"{report.stem}: {name}"


def print_report(folder):
    """Print both tables."""
    rows = list(parts(folder / "times"))
    print(f"\n{'part':20}{'seconds':>10}{'processor seconds':>20}")
    for part, seconds, processor in rows:
        print(f"{part:20}{seconds:10.0f}{processor:20.0f}")
    print(f"{'all':20}{'':10}{sum(row[2] for row in rows):20.0f}")
    print(f"\nThe {COUNT} slowest tests, in seconds:")
    found = sorted((test for report in folder.glob("*.xml") for test in tests(report)), reverse=True)
    for seconds, name in found[:COUNT]:
        print(f"{seconds:8.1f}  {name}")


if __name__ == "__main__":
    print_report(Path(sys.argv[1]))
