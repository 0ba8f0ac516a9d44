"""The sources inside the units: `fmpy compile` makes a working unit of one that has lost its binaries."""

import os
import shutil
import zipfile

import fmpy
import pytest
import tdmf_slip
from conftest import QUANTITIES, RELEASE, run_python, unit_reference

REFERENCE = unit_reference()
PAIRS = [(3, "clang"), (2, "clang"), (2, "gcc"), (3, "gcc")]
"""FMI version and compiler. The units share the core, and GCC builds the package's: by default the first."""
WITHOUT_OPTIMISATION = 'set(CMAKE_C_FLAGS_RELEASE "-O0 -DNDEBUG" CACHE STRING "")'
"""A toolchain for CMake that compiles a unit in a fifth of the time that FMPy's own -O3 takes."""
SOLVER = "solver.method"


def without_binaries(source, target):
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "w") as new:
        for entry in old.infolist():
            if not entry.filename.startswith("binaries"):
                new.writestr(entry, old.read(entry))
    return target


def library_names(unit):
    with zipfile.ZipFile(unit) as file:
        return [name for name in file.namelist() if name.startswith("binaries") and not name.endswith("/")]


@pytest.fixture(scope="module", params=PAIRS if RELEASE else PAIRS[:1], ids=str)
def compiled(request, tmp_path_factory):
    """A unit that was compiled from its own sources: FMI version and compiler."""
    version, compiler = request.param
    if shutil.which(compiler) is None or shutil.which("cmake") is None:
        pytest.skip(f"{compiler} or cmake is not installed")
    unit = without_binaries(tdmf_slip.fmu_path(version), tmp_path_factory.mktemp("sources") / "TDMF_SLIP.fmu")
    assert library_names(unit) == []
    variables = os.environ | {"CC": compiler}
    if not RELEASE:
        toolchain = unit.parent / "toolchain.cmake"
        toolchain.write_text(WITHOUT_OPTIMISATION, encoding="utf-8")
        variables["CMAKE_TOOLCHAIN_FILE"] = str(toolchain)
    options = {"env": variables, "cwd": unit.parent}
    done = run_python("-m", "fmpy", "compile", unit, "--all-warnings", **options)
    said = done.stdout + done.stderr
    assert done.returncode == 0 and "warning" not in said, said
    assert len(library_names(unit)) == 1
    return str(unit)


@pytest.mark.parametrize("interface", ["ModelExchange", "CoSimulation"])
def test_ten_strides(compiled, interface):
    rows = fmpy.simulate_fmu(
        compiled,
        fmi_type=interface,
        stop_time=251.0,
        output_interval=1.0,
        relative_tolerance=1e-9,
        output=[f"stride.{name}" for name in (*QUANTITIES, "count")],
    )
    assert rows["stride.count"][-1] == 10
    tolerance = {"ModelExchange": 1e-6, "CoSimulation": 1e-8}[interface]
    for name in QUANTITIES:
        assert rows[f"stride.{name}"][-1] == pytest.approx(REFERENCE[name], rel=tolerance), name


def test_cvode_is_refused_in_words(compiled):
    """The run has its own process, where the unit's message goes to FMPy's own logger."""
    program = "import fmpy, sys; fmpy.simulate_fmu(sys.argv[1], fmi_type='CoSimulation', stop_time=1.0, "
    program += f"debug_logging=True, start_values={{{SOLVER!r}: 2}})"
    done = run_python("-c", program, compiled)
    assert done.returncode != 0 and "ExitInitializationMode" in done.stderr
    assert "built without SUNDIALS" in done.stdout


@pytest.mark.parametrize("version", [2, 3])
def test_headers_and_sources_are_complete_and_no_more(version):
    """Every C file that lies in the unit is in its list of files, and the other way round."""
    path = str(tdmf_slip.fmu_path(version))
    description = fmpy.read_model_description(path)
    (configuration,) = description.buildConfigurations[:1]
    (files,) = configuration.sourceFileSets
    with zipfile.ZipFile(path) as unit:
        names = {name.removeprefix("sources/") for name in unit.namelist() if name.startswith("sources/")}
    assert {name for name in names if name.endswith(".c")} == set(files.sourceFiles)
    other = "fmi3_" if description.fmiVersion == "2.0" else "fmi2_"
    assert not [name for name in names if name.startswith(other)]
