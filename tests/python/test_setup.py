"""What the scripts install: Debian packages with leave only, Python packages by exact versions and hashes."""

import importlib.metadata
import json
import os
import re
import subprocess
import sys
import tomllib

import pytest
from conftest import HANGS, ROOT, succeed

packaging = pytest.importorskip("packaging.requirements")
utils = pytest.importorskip("packaging.utils")

LOCKS = ROOT / "scripts" / "locks"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
DEPENDENCIES = PROJECT["project"]["dependencies"]
EXTRAS = PROJECT["project"]["optional-dependencies"]
PARTS = ("plots", "cluster", "proof")
"""Extras that a user may leave out; `all` has every one."""
OPTIONAL = [text for name in PARTS for text in EXTRAS[name]]
OF_TESTS = [text for name in ("test", "importers") for text in EXTRAS[name]]


def locked(*names):
    """Version by package of some locks, and which of the hashes' lines there are."""
    versions = {}
    for name in names:
        text = (LOCKS / f"{name}.txt").read_text(encoding="utf-8").replace("\\\n", " ")
        for line in text.splitlines():
            if line.startswith("#"):
                continue
            found = re.fullmatch(
                r"([a-z0-9-]+)==(\S+)( ; [^#]+?)?((?: +--hash=sha256:[0-9a-f]{64})+) *", line
            )
            assert found, line
            versions[found[1]] = found[2]
    return versions


@pytest.mark.parametrize(
    ("lock", "requirements", "least"),
    [
        ("environment", PROJECT["build-system"]["requires"], 2),
        ("environment", DEPENDENCIES, 7),
        ("environment", OPTIONAL, 3),
        ("test", OF_TESTS, 11),
        ("bench", EXTRAS["bench"], 2),
        ("zig", EXTRAS["zig"], 1),
        ("platforms", EXTRAS["platforms"], 4),
        ("site", EXTRAS["site"], 5),
        ("fmi_sim", EXTRAS["fmi-sim"], 1),
    ],
)
def test_a_lock_has_what_pyproject_asks_for(lock, requirements, least):
    versions = locked(lock)
    assert len(requirements) >= least
    for text in requirements:
        requirement = packaging.Requirement(text)
        assert requirement.specifier.contains(versions[utils.canonicalize_name(requirement.name)]), text


def test_locks_agree_and_have_all_that_is_needed_in_turn():
    """As the installed packages tell what they need."""
    versions, checked = {}, 0
    for lock in map(locked, ("environment", "test", "bench", "zig", "platforms", "site")):
        assert all(versions.get(name, version) == version for name, version in lock.items())
        versions |= lock
    for name, version in versions.items():
        try:
            distribution = importlib.metadata.distribution(name)
        except importlib.metadata.PackageNotFoundError:
            continue
        if distribution.version != version:
            continue
        for text in distribution.requires or []:
            requirement = packaging.Requirement(text)
            if requirement.marker is None or requirement.marker.evaluate({"extra": ""}):
                there = versions[utils.canonicalize_name(requirement.name)]
                assert requirement.specifier.contains(there), f"{name}: {text}"
                checked += 1
    if not checked:
        pytest.skip("NOT TESTED: locks, because none of their packages is installed")
    assert checked > 50


def test_one_extra_has_all_others_that_a_user_may_leave_out():
    (text,) = EXTRAS["all"]
    assert packaging.Requirement(text).extras == set(PARTS)


def test_the_package_itself_pins_nothing():
    """It lives beside other packages; the scripts' environment is another matter."""
    extras = (text for name in (*PARTS, "bench") for text in EXTRAS[name])
    for text in [*DEPENDENCIES, *extras, *PROJECT["build-system"]["requires"]]:
        operators = {specifier.operator for specifier in packaging.Requirement(text).specifier}
        assert operators == {">="}, text


def test_scripts_install_python_packages_by_hash_only():
    text = "".join(
        (ROOT / "scripts" / name).read_text()
        for name in ("setup.sh", "run", "test", "check", "release", "site")
    )
    assert len(re.findall(r"pip install .*", text)) == 1  # in pip_install
    calls = re.findall(r"^ *(?:step \".*\" +)?pip_install .*", text.replace("\\\n", " "), re.MULTILINE)
    assert len(calls) == 3
    assert all("--require-hashes" in call or re.search(r"--no-deps .*\.$", call) for call in calls), calls


# ---- Debian packages ----

POSIX_ONLY = pytest.mark.skipif(
    os.name != "posix" or sys.platform == "darwin", reason="the scripts are for Linux"
)
COMMANDS = {
    "dpkg-query": "exit 1",
    "id": "echo $USER_NUMBER",
    "sudo": 'echo "sudo $*" >>"$CALLS"; "$@"',
    "apt-get": 'echo "apt-get $*" >>"$CALLS"; cat',
}


@pytest.fixture
def need(tmp_path):
    """Lets the scripts need a package that is missing, among commands that only note how they are called."""
    folder, calls = tmp_path / "bin", tmp_path / "calls"
    folder.mkdir()
    calls.touch()
    for name, body in COMMANDS.items():
        (folder / name).write_text(f"#!/bin/sh\n{body}\n")
        (folder / name).chmod(0o755)

    def run(user, stdin, stderr=subprocess.PIPE):
        environment = os.environ | {
            "PATH": f"{folder}:{os.environ['PATH']}",
            "USER_NUMBER": str(user),
            "CALLS": str(calls),
        }
        script = f"set -euo pipefail; source {ROOT}/scripts/setup.sh; need_debian_packages some-package"
        process = subprocess.Popen(["bash", "-c", script], stdin=stdin, stderr=stderr, env=environment)
        return process, lambda: calls.read_text().splitlines()

    return run


INSTALLED = "apt-get install -y -qq --no-install-recommends some-package"


@POSIX_ONLY
def test_root_installs_without_a_question(need):
    process, calls = need(0, subprocess.PIPE)  # which says nothing and does not end
    assert process.wait(HANGS) == 0
    process.communicate()
    assert calls() == ["apt-get update -qq", INSTALLED]


@POSIX_ONLY
@pytest.mark.parametrize("stdin", [subprocess.PIPE, subprocess.DEVNULL])
def test_without_a_terminal_nobody_is_asked_and_sudo_is_not_used(need, stdin):
    process, calls = need(1000, stdin)
    assert process.wait(HANGS) == 1
    _, said = process.communicate()
    assert b"apt-get install some-package" in said and calls() == []


@POSIX_ONLY
@pytest.mark.parametrize(("answer", "does"), [("Yes", True), ("n", False), ("\4", False)])
def test_at_a_terminal_sudo_is_used_after_asking_only(need, answer, does):
    terminal, other = os.openpty()
    process, calls = need(1000, other, other)
    os.close(other)
    said = b""
    while b"[y/N]" not in said:
        said += os.read(terminal, 1000)
    assert b"some-package" in said and calls() == []
    os.write(terminal, f"{answer}\n".encode() if answer != "\4" else b"\4")
    try:
        while chunk := os.read(terminal, 1000):
            said += chunk
    except OSError:  # its other end is closed
        pass
    assert process.wait(HANGS) == (0 if does else 1)
    os.close(terminal)
    if does:
        assert [call for call in calls() if call.startswith("sudo")] == [
            "sudo apt-get update -qq",
            f"sudo env DEBIAN_FRONTEND=noninteractive {INSTALLED}",
        ]
    else:
        assert calls() == [] and b"please install" in said


# ---- what CONTRIBUTING and the development guide say ----


def test_the_development_guide_names_files_that_there_are():
    files = "\n".join(f"/{name}" for name in succeed("git", "ls-files", cwd=ROOT).splitlines())
    for page in ("architecture", "pages"):
        text = (ROOT / f"documentation/development/{page}.md").read_text(encoding="utf-8")
        named = set(re.findall(r"`([\w/]+\.(?:c|h|py|json))`", text)) - {"sources/unit_names.h"}
        assert len(named) > 5
        assert [name for name in named if f"/{name}\n" not in files] == []


def test_the_fast_tests_of_a_check_are_there():
    (names,) = re.findall(
        r"^FAST_TESTS=\((.+?)\)", (ROOT / "scripts/check").read_text(encoding="utf-8"), re.S | re.M
    )
    assert len(names.split()) > 5
    assert [name for name in names.split() if not (ROOT / f"tests/python/{name}.py").is_file()] == []


def test_contributing_names_scripts_and_presets_that_there_are():
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    scripts = set(re.findall(r"^(?:\./)?scripts/(\w+)\b", text, re.MULTILINE))
    assert len(scripts) >= 6
    assert all(os.access(ROOT / "scripts" / name, os.X_OK) for name in scripts), scripts
    presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
    there = {preset["name"] for preset in presets["configurePresets"]}
    named = set(re.findall(r"--preset (\w+)", text)) | set(
        re.findall(r"`(\w+)`", text.split("CMake presets:")[1][:150])
    )
    assert len(named) >= 5 and named <= there, named - there
    assert {preset["configurePreset"] for preset in presets["testPresets"]} <= there


def test_a_public_host_runs_all_parts_of_the_same_script():
    workflow = (ROOT / ".github" / "workflows" / "test.yml").read_text(encoding="utf-8")
    assert "run: ./scripts/test ${{ matrix.tests }}\n" in workflow
    script = (ROOT / "scripts" / "test").read_text(encoding="utf-8")
    parts = re.search(r"^PARTS=\((.*)\)$", script, re.MULTILINE)[1].split()
    jobs = re.findall(r"^ +- (--.*)$", workflow, re.MULTILINE)
    assert len(parts) == 5 and set(jobs) >= {f"--only {part}" for part in parts}
    assert set(jobs) >= {f"--release --only {part}" for part in ("lint", "c", "site", "python", "platforms")}
    assert (ROOT / ".ci" / "run").read_text().rstrip().endswith("exec ./scripts/test")


def test_the_parts_of_the_tests_have_files_that_there_are():
    script = (ROOT / "scripts" / "test").read_text(encoding="utf-8")
    files = re.findall(r"^[A-Z]+_TESTS=\(([^)]*)\)$", script, re.MULTILINE)
    names = " ".join(files).split()
    assert len(files) == 2 and len(names) == 11
    assert all((ROOT / "tests" / "python" / f"{name}.py").is_file() for name in names), names


@POSIX_ONLY
@pytest.mark.parametrize(("options", "more"), [((), ""), (("--release",), " platforms")])
def test_a_part_that_there_is_not_is_refused(options, more):
    command = [ROOT / "scripts" / "test", *options, "--only", "all"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 1
    assert f"--only takes one of: lint c sanitize site python{more}; it was given 'all'" in done.stderr


REPORT = """<testsuites><testsuite><testcase classname="tests.python.test_one" name="test_a" time="{}"/>
<testcase classname="tests.python.test_one" name="test_b" time="{}"/></testsuite></testsuites>"""


def test_the_parts_and_the_slowest_tests_of_all_reports_are_printed(tmp_path):
    (tmp_path / "times").write_text("set-up;70.5;60.25;5.25\nlint;40.0;55.0;1.0\n")
    (tmp_path / "python.xml").write_text(REPORT.format(0.5, 12.25))
    (tmp_path / "release.xml").write_text('<testsuite><testcase name="test_impact" time="3.5"/></testsuite>')
    for number in range(10):
        (tmp_path / f"more{number}.xml").write_text(REPORT.format(0.75, 0.0))
    command = [sys.executable, ROOT / "scripts" / "slowest_tests.py", tmp_path]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    times, slowest = done.stdout.split("slowest tests")
    assert [line.split() for line in times.splitlines()[2:5]] == [
        ["set-up", "70", "66"],
        ["lint", "40", "56"],
        ["all", "122"],
    ]
    listed = [line.split() for line in slowest.splitlines()[1:]]
    assert [float(seconds) for seconds, *_ in listed] == [12.2, 3.5, *8 * [0.8]]
    assert [name[-1] for _, *name in listed[:2]] == ["test_one::test_b", "test_impact"]


def test_no_workflow_may_write_to_the_repository_unless_a_job_asks_for_it():
    yaml = pytest.importorskip("yaml")
    workflows = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
    assert len(workflows) >= 1
    for path in workflows:
        assert yaml.safe_load(path.read_text(encoding="utf-8"))["permissions"] == {"contents": "read"}, path


def test_a_workflow_runs_actions_by_their_commit_and_leaves_no_credentials():
    yaml = pytest.importorskip("yaml")
    pinned, checkouts = 0, 0
    for path in (ROOT / ".github" / "workflows").glob("*.yml"):
        jobs = yaml.safe_load(path.read_text(encoding="utf-8"))["jobs"].values()
        for step in (step for job in jobs for step in job["steps"] if "uses" in step):
            assert re.fullmatch(r"[\w-]+/[\w-]+@[0-9a-f]{40}", step["uses"]), f"{path.name}: {step['uses']}"
            pinned += 1
            if step["uses"].startswith("actions/checkout@"):
                assert step["with"]["persist-credentials"] is False, path.name
                checkouts += 1
    assert pinned >= 7 and checkouts >= 2
