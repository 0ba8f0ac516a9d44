"""Names that were replaced are used nowhere any more.

The unit's names and enumeration items, JSON keys and ordinary prose are free to use the words.
"""

import inspect
import io
import pathlib
import re
import subprocess
import tokenize

import pytest
import tdmf_slip

ROOT = pathlib.Path(__file__).parents[2]
COMMENTS = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"', re.DOTALL)

REPLACED = {
    ("c_core", "fmu_src", "tests/c", "documentation", "examples"): """
        choice_of pick_whole whole_of real_of whole_bias bits_of_whole whole_of_bits lanes_of
        tdmf_fall_of_body tdmf_fall_of_center tdmf_fall_has_no_derivative
        tdmf_place_along place_integral
        tdmf_ensemble_place tdmf_reduced_place live_state_place live_samples_place
        turns_of force_turn next_turn TURN_LIMIT expand_slip_turning expand_stick_turning
        tdmf_side side_of side_after tdmf_side_by_side mobility
        tdmf_held_inputs tdmf_rates_or_held tdmf_are_held
        most_strides most_change most_drop least_sum least_height most_change_in_layer most_growth_in_layer
        tdmf_least_sine least_normal least_room most_events PIECES_IN_A_CALL
        tdmf_piece_height TDMF_LEAST_PIECE tdmf_meets_piece live_values_place
        live_section_place place_of place_near_the_gait
        TDMF_NOTED_SERIES tdmf_notes_strides tdmf_runner_note_step note_found note_remainder crowd
        tdmf_change tdmf_direction tdmf_direction_of tdmf_tangent tdmf_tangent_along tdmf_stride_change
        tdmf_classic_change tdmf_reduced_change tdmf_reduced_return tdmf_reduced_orbit tdmf_reduced_outcome
        TDMF_RETURN_CHANGES TDMF_REDUCED_CHANGES by_section by_parameter bundle
        are_places start_place has_place pass_place turn_rows turn_columns tdmf_record_instant
        find_turns add_turns_of add_turns_in_flight add_turns_on_ground find_turns_of_power turn_by
        forget_view forget_messages note_message note_foot notes_peaks_and_positive_work assert_noted
        state_along variation_along expand_drop_along shift_along change_of_ground change_of_speed
        exact_change write_change direction_of tangent_agrees tangent_agrees_along fmu_direction along_length
        present_unit unit_calls unit_description unit_functions load_unit
        is_held MOST LEAST PIECES SIDES
        unit_settings unit_work unit_view unit_variable unit_variables unit_reset unit_start unit_prepare
    """,
    ("fmu_src", "tests/c", "documentation", "examples"): """
        held pick piece pieces place told tangent directions
    """,
    ("c_core",): """
        choice pick whole not fall places held stretch least noted turns
    """,
}
"""Identifiers of C by the folders in which they are not found: some are words that others may use."""


def code_of(path: pathlib.Path) -> str:
    """A file of C without its comments and strings."""
    return COMMENTS.sub(" ", path.read_text(encoding="utf-8"))


def c_files(folders: tuple[str, ...]) -> list[pathlib.Path]:
    """The files of C in folders, as git knows them or, without it, as they lie there."""
    listed = subprocess.run(
        ["git", "ls-files", *folders], cwd=ROOT, capture_output=True, text=True, check=False
    ).stdout.split()
    paths = [ROOT / name for name in listed] or [p for folder in folders for p in (ROOT / folder).rglob("*")]
    return [path for path in paths if path.suffix in (".c", ".h") and path.is_file()]


@pytest.mark.parametrize("folders", REPLACED)
def test_no_replaced_identifier_is_left_in_c(folders):
    names = set(REPLACED[folders].split())
    files = c_files(folders)
    assert len(files) > 100
    left = [
        f"{path.relative_to(ROOT)}: {name}"
        for path in files
        for name in sorted(set(re.findall(r"\w+", code_of(path))))
        if name in names or name.startswith(("MOST_", "LEAST_"))
    ]
    assert left == []


def test_a_replaced_identifier_would_be_found(tmp_path):
    path = tmp_path / "old.c"
    path.write_text('/* choice */ static int pick(int x) { return x; } const char *a = "whole";\n')
    found = set(re.findall(r"\w+", code_of(path)))
    assert "pick" in found and not found & {"choice", "whole"}


# ---- Python ------------------------------------------------------------------------------------------------

PYTHON_FOLDERS = ("scripts/tdmf_slip", "examples")
REPLACED_IN_PYTHON = {
    "Orbit",
    "find_orbit",
    "orbits",
    "OrderNotMetError",
    "run_batch",
    "simulate_over",
    "ranges_given",
    "runner_by",
    "Crowd",
    "crowd",
    "noted_strides",
    "Happenings",
    "happenings",
    "Stretch",
    "stretches",
    "Told",
    "told",
    "NotedEvent",
    "noted",
    "at_most",
    "StrideChange",
    "settle_unit",
    "measure_unit",
    "_of_unit",
    "ClassicChange",
    "HELD_ON_TERRAIN",
    "_jacobian_changes",
    "MAX_TURNS",
    "FORGOTTEN",
    "forgotten",
    "mobility",
    "unmovable",
    "is_least",
    "settings_at",
    "setting_weight",
    "show_progress",
    "most_strides",
    "most_points",
    "most_gaits",
    "largest_step",
    "held_gait",
    "communication_step",
    "check_place",
    "place_of",
    "piece_length",
    "stay_all",
}
REPLACED_ARGUMENTS = {
    "over",
    "free",
    "free_each",
    "at",
    "order",
    "settings",
    "workers",
    "table",
    "cases",
    "ranges",
    "parameters",
    "start_values",
    "unit",
    "most_strides",
    "most_points",
    "most_gaits",
    "largest_step",
    "forgotten",
    "relative_tolerance",
    "show_progress",
    "communication_step",
    "setting_weight",
    "name",
    "end",
}
"""Of functions at the top of the package: words that are names of something else elsewhere."""
REPLACED_ATTRIBUTES = {
    "orbits",
    "stretches",
    "is_least",
    "forgotten",
    "mobility",
    "unmovable",
    "settings",
    "pieces",
}
REPLACED_OPTIONS = re.compile(
    r"(?<![\w-])--(?:over|free|free-each|at|most-strides|piece-length|workers|range)(?![\w-])"
)
CELL = re.compile(r"^```(?:\{code-cell\} python|python)\n(.*?)^```", re.MULTILINE | re.DOTALL)


def python_texts():
    """The code of the package and of the examples, and the cells of the guides."""
    for folder in PYTHON_FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.py")):
            yield str(path.relative_to(ROOT)), path.read_text(encoding="utf-8")
    for path in sorted((ROOT / "documentation").rglob("*.md")):
        for number, cell in enumerate(CELL.findall(path.read_text(encoding="utf-8"))):
            yield (
                f"{path.relative_to(ROOT)}, cell {number}",
                re.sub(r"^[:%!].*$", "", cell, flags=re.MULTILINE),
            )


def names_in(code):
    return {
        token.string
        for token in tokenize.generate_tokens(io.StringIO(code).readline)
        if token.type == tokenize.NAME
    }


def test_no_replaced_identifier_is_left_in_python():
    texts = list(python_texts())
    assert len(texts) > 350
    left = [
        f"{where}: {name}"
        for where, code in texts
        for name in sorted(names_in(code))
        if name in REPLACED_IN_PYTHON or name.startswith(("MOST_", "LEAST_"))
    ]
    assert left == []


def test_no_replaced_argument_or_attribute_is_left_at_the_top():
    functions, classes = 0, 0
    for name in tdmf_slip.__all__:
        thing = getattr(tdmf_slip, name)
        if inspect.isfunction(thing):
            assert not REPLACED_ARGUMENTS & set(inspect.signature(thing).parameters), name
            functions += 1
        elif inspect.isclass(thing):
            fields = getattr(thing, "__dataclass_fields__", {})
            assert not REPLACED_ATTRIBUTES & {*vars(thing), *fields}, name
            classes += 1
    assert functions >= 20 and classes >= 20


def test_no_replaced_option_is_left_in_guides_and_examples():
    paths = [
        path
        for folder in ("documentation", "examples")
        for path in (ROOT / folder).rglob("*")
        if path.suffix in (".md", ".py", ".ipynb", ".toml") and "build" not in path.parts
    ]
    assert len(paths) > 60
    left = [
        f"{path.relative_to(ROOT)}: {found}"
        for path in [*paths, ROOT / "README.md"]
        for found in REPLACED_OPTIONS.findall(path.read_text(encoding="utf-8"))
    ]
    assert left == []


def test_no_folder_or_module_calls_the_fmu_a_unit():
    paths = [path for path in (ROOT / "scripts").rglob("*.py") if "installed" not in path.parts]
    assert len(paths) > 300
    left = [path for path in paths if {"unit", "unit.py", "merge_units.py"} & set(path.parts)]
    assert left == []
    imports = re.compile(r"from \.+unit\b|tdmf_slip\.unit\b")
    assert [where for where, code in python_texts() if imports.search(code)] == []


def test_a_replaced_name_of_python_would_be_found():
    assert names_in('x = find_orbit(most=1)  # crowd "Told"') & REPLACED_IN_PYTHON == {"find_orbit"}
    assert REPLACED_OPTIONS.search("sweep --over leg.damping=1:2:3")
    assert not REPLACED_OPTIONS.search("compare --at-rest, --range-of")
