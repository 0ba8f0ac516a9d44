"""Releases: the papers that go with the binaries, and the same bytes when built twice."""

import hashlib
import json
import os
import re
import shutil
import tomllib
import zipfile

import pytest
from conftest import ROOT, run_python

SCRIPTS = ROOT / "scripts"
DIST = ROOT / "dist"
CONFIGURATION = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PROJECT, BUILD_SYSTEM = CONFIGURATION["project"], CONFIGURATION["build-system"]
pytest.importorskip("ziglang", reason="NOT TESTED: releases; ./scripts/release installs what makes them")

with pytest.MonkeyPatch.context() as patch:  # not for longer: that folder has the package's sources, too
    patch.syspath_prepend(SCRIPTS)
    import merge_fmus
    import release_files

VERSION = release_files.version()
PAPERS = ("RELEASE_NOTES.md", f"tdmf-slip-{VERSION}.cdx.json", "recipe.yaml", "SHA256SUMS")


def make_papers(folder, **variables):
    return run_python(SCRIPTS / "release_files.py", folder, env=os.environ | variables)


@pytest.fixture(scope="module")
def released(tmp_path_factory):
    """A folder with files of the names that a release has, and what was made of them."""
    folder = tmp_path_factory.mktemp("dist")
    tags = [tag for tag in release_files.KINDS if "_" in tag and "." not in tag]
    assert len(tags) == 6
    wheels = [f"tdmf_slip-{VERSION}-py3-none-{tag}.whl" for tag in tags]
    for name in ("TDMF_SLIP.fmu", "TDMF_SLIP_FMI3.fmu", f"tdmf_slip-{VERSION}.tar.gz", *wheels):
        (folder / name).write_text(f"content of {name}")
    made = make_papers(folder, SOURCE_DATE_EPOCH="1700000000")
    assert made.returncode == 0, made.stderr
    return folder


def read(folder, name):
    return (folder / name).read_text(encoding="utf-8")


def test_the_sums_are_those_of_every_file(released):
    printed = dict(line.split("  ")[::-1] for line in read(released, "SHA256SUMS").splitlines())
    assert set(printed) == {path.name for path in released.iterdir()} - {"SHA256SUMS"} and len(printed) == 12
    for name, written_sum in printed.items():
        assert written_sum == hashlib.sha256((released / name).read_bytes()).hexdigest(), name


def test_the_notes_are_this_version_s_changes_and_every_file(released):
    notes = read(released, "RELEASE_NOTES.md")
    changes = read(ROOT, "CHANGELOG.md").split(f"## {VERSION}")[1].split("\n", 1)[1].split("\n## ")[0].strip()
    assert notes.startswith(f"# TDMF-SLIP {VERSION}\n\n{changes}\n\n## Files\n")
    files = notes.partition("\n\n## Files\n")[2]
    named = set(re.findall(r"^\| `([^`]+)` \| \S.+ \|$", files, re.MULTILINE))
    assert named == {path.name for path in released.iterdir()} - {"RELEASE_NOTES.md", "SHA256SUMS"}


def test_a_version_without_changes_is_refused():
    changelog = "# Changelog\n\n## 1.0.1\n\nb\n\n## 1.0.0 (today)\n\n### Added\n- a\n\n## 1.0\n"
    assert release_files.section_of(changelog, "1.0.0") == "### Added\n- a"
    assert release_files.section_of(changelog, "1.0.1") == "b"
    for missing in ("1.0.2", "0.1", "1"):
        with pytest.raises(SystemExit, match=rf"0 sections of version {re.escape(missing)}"):
            release_files.section_of(changelog, missing)


def test_the_bill_of_materials_is_valid_and_whole(released):
    validation = pytest.importorskip("cyclonedx.validation.json")
    from cyclonedx.schema import SchemaVersion

    text = read(released, f"tdmf-slip-{VERSION}.cdx.json")
    validator = validation.JsonStrictValidator(SchemaVersion.V1_6)
    assert validator.validate_str(text) is None
    assert validator.validate_str(text.replace('"library"', '"books"')) is not None
    bill = json.loads(text)
    subject = bill["metadata"]["component"]
    assert (subject["name"], subject["version"]) == ("tdmf-slip", VERSION)
    hashes = {file["name"]: file["hashes"][0]["content"] for file in subject["components"]}
    sums = dict(line.split("  ")[::-1] for line in read(released, "SHA256SUMS").splitlines())
    assert (
        hashes == {name: printed for name, printed in sums.items() if name not in PAPERS} and len(hashes) == 9
    )
    names = {component["name"] for component in bill["components"]}
    direct = {re.match(r"[\w-]+", need)[0].lower() for need in PROJECT["dependencies"]}
    assert direct | {"ziglang", "pycparser", "attrs", "lxml"} <= names and len(names) > 20
    references = {component["bom-ref"] for component in bill["components"]} | {subject["bom-ref"]}
    depends = {row["ref"]: set(row["dependsOn"]) for row in bill["dependencies"]}
    assert set().union(*depends.values()) <= references and set(depends) <= references
    reached, due = set(), [subject["bom-ref"]]
    while due:
        reference = due.pop()
        due += depends.get(reference, set()) - reached
        reached.add(reference)
    assert reached == references


def test_the_recipe_is_one_that_rattler_build_takes(released):
    rattler = pytest.importorskip("rattler_build")
    text = read(released, "recipe.yaml")
    assert "@" not in text
    (variant,) = rattler.Stage0Recipe.from_yaml(text).render(
        rattler.VariantConfig({"c_compiler": ["gcc"], "c_stdlib": ["sysroot"]})
    )
    recipe = variant.recipe.to_dict()
    assert (recipe["package"]["name"], recipe["package"]["version"]) == ("tdmf-slip", VERSION)
    (source,) = recipe["source"]
    assert source["url"].endswith(f"/tdmf_slip-{VERSION}.tar.gz")
    archive = (released / f"tdmf_slip-{VERSION}.tar.gz").read_bytes()
    assert source["sha256"] == hashlib.sha256(archive).hexdigest()
    run = [
        re.sub(r"[ >=].*", "", need) for need in re.findall(r"^    - (.+)$", text.split("  run:")[1], re.M)
    ]
    assert {re.match(r"[\w-]+", need)[0].lower() for need in PROJECT["dependencies"]} <= set(run)
    host = re.findall(r"^    - ([\w-]+)", text.split("  host:")[1].split("  run:")[0], re.M)
    needed = {re.match(r"[\w-]+", need)[0] for need in BUILD_SYSTEM["requires"]}
    assert len(needed) > 2 and needed <= set(host)
    with pytest.raises(rattler.RattlerBuildError):
        rattler.Stage0Recipe.from_yaml(text.replace("requirements:", "needs:"))


def test_the_papers_are_the_same_bytes_twice(released, tmp_path):
    again = tmp_path / "again"
    shutil.copytree(released, again)
    for name in PAPERS:
        (again / name).unlink()
    assert make_papers(again, SOURCE_DATE_EPOCH="1700000000", PYTHONHASHSEED="7").returncode == 0
    for name in PAPERS:
        assert (again / name).read_bytes() == (released / name).read_bytes(), name


def test_a_release_that_lacks_a_file_gets_no_papers(released, tmp_path):
    for path in released.iterdir():
        if path.name not in (*PAPERS, "TDMF_SLIP.fmu"):
            shutil.copy(path, tmp_path)
    made = make_papers(tmp_path)
    assert made.returncode != 0 and "8 files of a release; 9 are needed" in made.stderr
    assert [name for name in PAPERS if (tmp_path / name).exists()] == []


@pytest.mark.skipif(not (DIST / "SHA256SUMS").is_file(), reason="NOT TESTED: ./scripts/release makes it")
def test_what_was_made_has_its_papers():
    sums = dict(line.split("  ")[::-1] for line in read(DIST, "SHA256SUMS").splitlines())
    assert len(sums) == 12
    for name, printed in sums.items():
        assert printed == hashlib.sha256((DIST / name).read_bytes()).hexdigest(), name


# ---- the same bytes ----


def write_unit(path, names, date):
    path.parent.mkdir(parents=True)
    with zipfile.ZipFile(path, "w") as unit:
        for name in names:
            unit.writestr(zipfile.ZipInfo(name, date), f"content of {name}")


def test_units_do_not_depend_on_when_and_in_which_order_they_were_zipped(tmp_path, monkeypatch):
    names = ["binaries/linux64/a.so", "modelDescription.xml", "sources/a.c", "sources/b.c"]
    dates = [(2020, 1, 1, 0, 0, 0), (2021, 2, 3, 4, 5, 6)]
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    made = []
    for order, date in zip((names, names[::-1]), dates, strict=True):
        folder = tmp_path / str(date[0])
        write_unit(folder / "x86_64-linux" / "TDMF_SLIP.fmu", order, date)
        merge_fmus.merge([folder / "x86_64-linux"], folder, "TDMF_SLIP.fmu")
        made.append((folder / "TDMF_SLIP.fmu").read_bytes())
        with zipfile.ZipFile(folder / "TDMF_SLIP.fmu") as unit:
            assert unit.namelist() == names
            assert {entry.date_time for entry in unit.infolist()} == {(2023, 11, 14, 22, 13, 20)}
            assert all(unit.read(name).decode() == f"content of {name}" for name in names)
    assert made[0] == made[1]
    monkeypatch.delenv("SOURCE_DATE_EPOCH")
    assert merge_fmus.entry_time() == (1980, 1, 1, 0, 0, 0)


# ---- what is cited and published ----


def test_zenodo_and_the_citation_say_the_same():
    yaml = pytest.importorskip("yaml")
    citation = yaml.safe_load(read(ROOT, "CITATION.cff"))
    zenodo = json.loads(read(ROOT, ".zenodo.json"))
    assert citation["version"] == VERSION
    assert zenodo["title"] == citation["title"] and zenodo["keywords"] == citation["keywords"]
    assert zenodo["license"] == citation["license"] == PROJECT["license"]
    assert [creator["name"] for creator in zenodo["creators"]] == [
        author["name"] for author in citation["authors"]
    ]
    (paper,), (related,) = citation["references"], zenodo["related_identifiers"]
    assert related["identifier"] == paper["doi"]


def test_only_the_publishing_job_may_write_and_it_runs_nothing_of_the_repository():
    yaml = pytest.importorskip("yaml")
    workflow = yaml.safe_load(read(ROOT / ".github" / "workflows", "release.yml"))
    assert workflow[True] == {"push": {"tags": ["v*"]}}  # YAML takes "on" for true
    build, publish = workflow["jobs"]["build"], workflow["jobs"]["publish"]
    assert workflow["permissions"] == {"contents": "read"} and "permissions" not in build
    assert "./scripts/release" in [step.get("run") for step in build["steps"]]
    assert publish["permissions"] == {"attestations": "write", "contents": "write", "id-token": "write"}
    assert publish["needs"] == "build"
    text = json.dumps(publish)
    assert "checkout" not in text and "./" not in text.replace("../", "")
