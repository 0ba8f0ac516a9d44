"""Names that were replaced are used nowhere any more.

The unit's names and enumeration items, JSON keys and ordinary prose are free to use the words.
"""

import pathlib
import re
import subprocess

import pytest

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
        TDMF_NOTED_SERIES tdmf_notes_strides tdmf_runner_note_step note_found note_remainder crowd
        tdmf_change tdmf_direction tdmf_direction_of tdmf_tangent tdmf_tangent_along tdmf_stride_change
        tdmf_classic_change tdmf_reduced_change tdmf_reduced_return tdmf_reduced_orbit tdmf_reduced_outcome
        TDMF_RETURN_CHANGES TDMF_REDUCED_CHANGES by_section by_parameter bundle
        unit_settings unit_work unit_view unit_variable unit_variables unit_reset unit_start unit_prepare
    """,
    ("c_core",): """
        choice pick whole not fall places held stretch least noted
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
        for name in sorted(names & set(re.findall(r"\w+", code_of(path))))
    ]
    assert left == []


def test_a_replaced_identifier_would_be_found(tmp_path):
    path = tmp_path / "old.c"
    path.write_text('/* choice */ static int pick(int x) { return x; } const char *a = "whole";\n')
    found = set(re.findall(r"\w+", code_of(path)))
    assert "pick" in found and not found & {"choice", "whole"}
