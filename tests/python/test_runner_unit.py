"""The runner's page behind the variables of modelDescription.xml, beside the unit that the package has."""

import random
import zipfile

import pytest
import tdmf_slip
from conftest import RELEASE
from page_runs import compiler
from test_structure import random_start
from unit_runs import UnitRun, unpacked

from c_core.hybrid.unit import unit_texts
from c_core.hybrid.unit_files import build_library, compile_unit, source_files, write_files
from c_core.pages.unit import runner_unit

OLD = str(tdmf_slip.fmu_path(2))
CONTINUOUS = "ground.friction", "hip.external_torque", "leg.extension", "body.external_fx"
JUMPS = {
    "ground__friction": (0.1, 1.0),
    "leg__extension": (-0.02, 0.02),
    "body__external_fx": (-0.01, 0.01),
    "control__stance_torque": (-0.05, 0.05),
    "ground__slope": (-0.1, 0.1),
    "hip__external_torque": (-0.05, 0.05),
    "leg__thrust": (0.0, 0.05),
}


@pytest.fixture(scope="module")
def new(tmp_path_factory):
    """The package's unit, in which the page replaces the library."""
    folder, unit = tmp_path_factory.mktemp("unit"), runner_unit()
    texts = unit_texts(unit) | {"guid.h": f'#define FMU_GUID "{unpacked(OLD)[1].guid}"\n'}
    files = source_files(unit, texts)
    write_files(folder, {f"sources/{name}": text for name, text in files.items()})
    objects = compile_unit(folder, compiler(), ["-O1"])
    library = build_library(folder, 2, "TDMF_SLIP", objects, compiler())
    with zipfile.ZipFile(OLD) as old, zipfile.ZipFile(folder / "TDMF_SLIP.fmu", "w") as made:
        for entry in old.infolist():
            if entry.filename.startswith("binaries/"):
                made.writestr(entry, library.read_bytes() if entry.filename.endswith(library.name) else b"")
            elif not entry.filename.startswith("sources/"):
                made.writestr(entry, old.read(entry))
    return str(folder / "TDMF_SLIP.fmu")


def played(unit, interface, seed):
    """A random run with jumps and, in Co-Simulation, ramps: its final values, or None after a fall."""
    draw = random.Random(seed)
    start = {name.replace(".", "__"): value for name, value in random_start(draw).items()}
    start["foot__y"] += 0.2
    run, values = UnitRun(unit, interface, **start), {}
    time = 0.0
    for _ in range(10):
        name, length = draw.choice(list(JUMPS)), draw.uniform(0.5, 2.0)
        value, public = draw.uniform(*JUMPS[name]), name.replace("__", ".")
        time += length
        if interface == "cs" and public in CONTINUOUS and length > 1.2:
            reference = run.of[public].valueReference
            run.fmu.setRealInputDerivatives([reference], [1], [(value - run[public]) / length])
            run.to(time)
        else:
            run.to(time, **values)
        values = {name: value}
    outputs = [
        v.name for v in run.of.values() if v.causality == "output" and not v.name.startswith("solver.")
    ]
    found = None if run["status.fallen"] else {name: run[name] for name in outputs}
    run.fmu.freeInstance()
    return found


@pytest.mark.parametrize("interface", ["cs", "me"])
def test_the_runners_page_runs_as_the_packages_unit_does(new, interface):
    """Every output, after random runs with jumps of all kinds of inputs and tunable parameters."""
    count = {"cs": 1500 if RELEASE else 150, "me": 200 if RELEASE else 10}[interface]
    tolerance = {"cs": 1e-10, "me": 1e-6}[interface]
    compared = 0
    for seed in range(count):
        old, found = (played(unit, interface, seed) for unit in (OLD, new))
        assert (old is None) == (found is None), seed
        for name, value in (old or {}).items():
            same = value if isinstance(value, str) else pytest.approx(value, rel=tolerance, abs=tolerance)
            assert found[name] == same, (seed, name)
            compared += 1
    assert compared > 20 * count
