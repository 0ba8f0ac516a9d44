#!/usr/bin/env python3
"""Make what goes with the files of a release: notes, a bill of materials, checksums.

    release_files.py DIST    the folder with units, wheels and source distribution

Into DIST: RELEASE_NOTES.md, the changelog's section of this version and what each file is; a software bill of
materials in CycloneDX's format; recipe.yaml for conda-forge; SHA256SUMS of every file there. The same files
give the same bytes.
"""

import argparse
import datetime
import hashlib
import importlib.metadata
import json
import os
import pathlib
import re
import tomllib
import uuid

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = pathlib.Path(__file__).resolve().parents[1]
RELEASED = ("*.fmu", "*.whl", "*.tar.gz")
NAME = "tdmf-slip"
BILL = f"{NAME}-{{version}}.cdx.json"
NOTES = "RELEASE_NOTES.md"
RECIPE = "recipe.yaml"
SUMS = "SHA256SUMS"
KINDS = {
    "TDMF_SLIP.fmu": "the unit in FMI 2.0, with the binaries of every platform and its sources",
    "TDMF_SLIP_FMI3.fmu": "the unit in FMI 3.0, likewise",
    "manylinux_2_17_x86_64": "Python package, Linux on x86-64",
    "manylinux_2_17_aarch64": "Python package, Linux on Arm",
    "win_amd64": "Python package, Windows on x86-64",
    "win_arm64": "Python package, Windows on Arm",
    "macosx_11_0_x86_64": "Python package, macOS on Intel's processors",
    "macosx_11_0_arm64": "Python package, macOS on Apple's processors",
    "tar": "sources",
}
"""Description of a file, by its name or by the last part of its stem."""


def version():
    """The version, whose numbers stand in the library's header."""
    header = (ROOT / "c_core" / "include" / "tdmf_slip" / "version.h").read_text("utf-8")
    found = re.findall(r"^#define TDMF_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", header, re.MULTILINE)
    return ".".join(found)


def section_of(changelog, wanted):
    """The changelog's section of a version, without its heading."""
    sections = re.split(r"^## ", changelog, flags=re.MULTILINE)
    found = [section for section in sections if re.match(re.escape(wanted) + r"\s", section)]
    if len(found) != 1:
        raise SystemExit(f"CHANGELOG.md: {len(found)} sections of version {wanted}; one is needed")
    return found[0].partition("\n")[2].strip()


def kind_of(name):
    """The description of a released file."""
    stem = name.removesuffix(".gz").rsplit(".", 1)
    return KINDS.get(name) or KINDS[stem[1] if stem[1] == "tar" else stem[0].rpartition("-")[2]]


def notes(files):
    """The page of a release."""
    rows = [f"| `{file.name}` | {kind_of(file.name)} |" for file in files]
    return "\n".join(
        [
            f"# TDMF-SLIP {version()}",
            "",
            section_of((ROOT / "CHANGELOG.md").read_text("utf-8"), version()),
            "",
            "## Files",
            "",
            "| file | what it is |",
            "| --- | --- |",
            *rows,
            f"| `{BILL.format(version=version())}` | software bill of materials, CycloneDX |",
            f"| `{RECIPE}` | recipe for conda-forge |",
            "",
            f"`sha256sum --check {SUMS}` compares the files with their checksums.",
            "",
        ]
    )


# ---- the bill of materials -----------------------------------------------------------------------------


def sha256(file):
    """A file's checksum."""
    return hashlib.sha256(file.read_bytes()).hexdigest()


def needs(package):
    """Packages that an installed package needs here, optional parts left out."""
    requirements = map(Requirement, importlib.metadata.requires(package) or [])
    return sorted(
        {
            canonicalize_name(requirement.name)
            for requirement in requirements
            if requirement.marker is None or requirement.marker.evaluate({"extra": ""})
        }
    )


def needed(package):
    """Package -> what it needs, of all that a package needs in the end."""
    found, due = {}, [package]
    while due:
        name = due.pop()
        if name not in found:
            found[name] = needs(name)
            due += found[name]
    return dict(sorted(found.items()))


def reference_of(package):
    """The package's address in the Python package index."""
    return f"pkg:pypi/{package}@{importlib.metadata.version(package)}"


def component(package):
    """An installed Python package."""
    about = importlib.metadata.metadata(package)
    made = {
        "type": "library",
        "bom-ref": reference_of(package),
        "name": package,
        "version": importlib.metadata.version(package),
        "purl": reference_of(package),
        "scope": "required",
    }
    if about.get("License-Expression"):
        made["licenses"] = [{"expression": about["License-Expression"]}]
    return made


def compiler():
    """Zig, of which a little is in every binary."""
    return component("ziglang") | {
        "type": "application",
        "description": "compiles the binaries; compiler-rt, and mingw-w64's start-up code, are in them",
    }


def headers():
    """FMI's headers, which the units are compiled with."""
    return {
        "type": "library",
        "bom-ref": "fmi-standard-headers",
        "name": "FMI 2.0 and 3.0 headers",
        "description": "as FMPy has them; declarations only",
        "scope": "required",
        "licenses": [{"license": {"id": "BSD-2-Clause"}}],
        "externalReferences": [{"type": "website", "url": "https://fmi-standard.org"}],
    }


def bill(files):
    """The bill of materials: what the package is, consists of and needs."""
    tree = needed(NAME)
    itself = reference_of(NAME)
    released = [
        {
            "type": "file",
            "bom-ref": f"file:{file.name}",
            "name": file.name,
            "description": kind_of(file.name),
            "hashes": [{"alg": "SHA-256", "content": sha256(file)}],
        }
        for file in files
    ]
    subject = component(NAME) | {"type": "application", "components": released}
    del subject["scope"]
    time = datetime.datetime.fromtimestamp(int(os.environ.get("SOURCE_DATE_EPOCH", "0")), datetime.UTC)
    depends = {reference_of(name): [reference_of(other) for other in others] for name, others in tree.items()}
    compiled = [compiler(), headers()]
    depends[itself] += [made["bom-ref"] for made in compiled]
    document = {
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {"timestamp": time.strftime("%Y-%m-%dT%H:%M:%SZ"), "component": subject},
        "components": [component(name) for name in tree if name != NAME] + compiled,
        "dependencies": [
            {"ref": reference, "dependsOn": sorted(others)} for reference, others in depends.items()
        ],
    }
    identity = uuid.uuid5(uuid.NAMESPACE_URL, json.dumps(document, sort_keys=True))
    return json.dumps({"serialNumber": f"urn:uuid:{identity}", **document}, indent=2) + "\n"


# ---- the recipe ----------------------------------------------------------------------------------------


def recipe(sources):
    """The recipe for conda-forge, of this version's source distribution and of what the package needs."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    run = "\n".join(f"    - {need.lower().replace('>=', ' >=')}" for need in project["dependencies"])
    text = (ROOT / "scripts" / "conda_forge.yaml").read_text("utf-8").partition("\n")[2]
    values = {"VERSION": version(), "SHA256": sha256(sources), "RUN": run}
    return re.sub("@(VERSION|SHA256|RUN)@", lambda found: values[found[1]], text)


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("dist", type=pathlib.Path)
    dist = parser.parse_args().dist
    files = sorted(file for pattern in RELEASED for file in dist.glob(pattern))
    if len(files) != len(KINDS):
        raise SystemExit(f"{dist}: {len(files)} files of a release; {len(KINDS)} are needed")
    (sources,) = dist.glob("*.tar.gz")
    made = {
        dist / NOTES: notes(files),
        dist / BILL.format(version=version()): bill(files),
        dist / RECIPE: recipe(sources),
    }
    for path, text in made.items():
        path.write_text(text, encoding="utf-8")
    lines = [f"{sha256(file)}  {file.name}\n" for file in sorted([*files, *made])]
    (dist / SUMS).write_text("".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main()
