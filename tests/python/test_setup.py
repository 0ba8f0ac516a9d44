"""Packages that the scripts install: Debian's only with leave, Python's by exact versions and hashes."""

import importlib.metadata
import json
import os
import re
import subprocess
import sys
import tomllib
from subprocess import DEVNULL, PIPE

import pytest
from conftest import HANGS, ROOT, run, succeed

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
    """The installed packages' own requirements are met."""
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


def test_the_package_pins_nothing_and_the_extra_all_has_all_others():
    """The package lives beside other packages; only the scripts' environment is pinned."""
    (text,) = EXTRAS["all"]
    assert packaging.Requirement(text).extras == set(PARTS)
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

    def run(user, stdin, stderr=PIPE):
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
@pytest.mark.parametrize(("user", "stdin"), [(0, PIPE), (1000, PIPE), (1000, DEVNULL)])
def test_without_a_terminal_only_root_installs_and_nobody_is_asked(need, user, stdin):
    process, calls = need(user, stdin)  # a pipe says nothing and does not end
    assert process.wait(HANGS) == (0 if user == 0 else 1)
    _, said = process.communicate()
    assert calls() == (["apt-get update -qq", INSTALLED] if user == 0 else [])
    assert user == 0 or b"apt-get install some-package" in said


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
    asked = ["sudo apt-get update -qq", f"sudo env DEBIAN_FRONTEND=noninteractive {INSTALLED}"]
    assert [call for call in calls() if call.startswith("sudo")] == (asked if does else [])
    assert does or (calls() == [] and b"please install" in said)


# ---- what scripts, workflows and the guides for developers name ----


def text_of(path):
    return (ROOT / path).read_text(encoding="utf-8")


def test_files_that_guides_and_scripts_name_exist():
    tracked = "\n".join(f"/{name}" for name in succeed("git", "ls-files", cwd=ROOT).splitlines())
    guides = "".join(text_of(f"documentation/development/{page}.md") for page in ("architecture", "pages"))
    named = set(re.findall(r"`([\w/]+\.(?:c|h|py|json))`", guides)) - {"sources/unit_names.h"}
    lists = re.findall(
        r"^\w+_TESTS=\(([^)]*)\)$", text_of("scripts/test") + text_of("scripts/check"), re.MULTILINE
    )
    assert len(named) > 10 and len(lists) == 3
    named |= {f"tests/python/{name}.py" for names in lists for name in names.split()}
    named |= {
        f"scripts/{name}"
        for name in re.findall(r"^(?:\./)?scripts/(\w+)\b", text_of("CONTRIBUTING.md"), re.M)
    }
    assert [name for name in named if f"/{name}\n" not in f"{tracked}\n"] == []


def test_presets_that_contributing_names_exist():
    text, presets = text_of("CONTRIBUTING.md"), json.loads(text_of("CMakePresets.json"))
    there = {preset["name"] for preset in presets["configurePresets"]}
    named = set(re.findall(r"--preset (\w+)", text))
    named |= set(re.findall(r"`(\w+)`", text.split("CMake presets:")[1][:150]))
    assert len(named) >= 5 and named <= there, named - there
    assert {preset["configurePreset"] for preset in presets["testPresets"]} <= there


def test_a_public_host_runs_all_parts_of_the_same_script():
    workflow = text_of(".github/workflows/test.yml")
    assert "run: ./scripts/test ${{ matrix.tests }}\n" in workflow
    parts = re.search(r"^PARTS=\((.*)\)$", text_of("scripts/test"), re.MULTILINE)[1].split()
    jobs = set(re.findall(r"^ +- (--.*)$", workflow, re.MULTILINE))
    assert len(parts) == 5 and jobs >= {f"--only {part}" for part in parts}
    assert jobs >= {f"--release --only {part}" for part in ("lint", "c", "site", "python", "platforms")}
    assert text_of(".ci/run").rstrip().endswith("exec ./scripts/test")


@POSIX_ONLY
@pytest.mark.parametrize(("options", "more"), [((), ""), (("--release",), " platforms")])
def test_a_part_that_there_is_not_is_refused(options, more):
    done = run(ROOT / "scripts" / "test", *options, "--only", "all")
    assert done.returncode == 1
    assert f"--only takes one of: lint c sanitize site python{more}; it was given 'all'" in done.stderr


def test_workflows_only_read_unless_a_job_asks_and_run_actions_by_their_commit():
    """A checkout leaves no credentials behind."""
    yaml, pinned = pytest.importorskip("yaml"), 0
    for path in (ROOT / ".github" / "workflows").glob("*.yml"):
        workflow = yaml.safe_load(path.read_text(encoding="utf-8"))
        assert workflow["permissions"] == {"contents": "read"}, path
        for step in (step for job in workflow["jobs"].values() for step in job["steps"] if "uses" in step):
            assert re.fullmatch(r"[\w-]+/[\w-]+@[0-9a-f]{40}", step["uses"]), f"{path.name}: {step['uses']}"
            is_checkout = step["uses"].startswith("actions/checkout@")
            assert not is_checkout or step["with"]["persist-credentials"] is False, path.name
            pinned += 1
    assert pinned >= 7
