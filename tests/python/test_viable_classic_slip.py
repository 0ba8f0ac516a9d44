"""Viable sets of the classic SLIP, cell by cell equal to those of the public program vibly (vibly_slip.json).

All its touchdown angles are admitted, those of 0 and below too.
"""

import numpy as np
import pytest
from references import read
from tdmf_slip.library import classic_slip
from tdmf_slip.viable_sets.grid import Boxes, largest_kept

REFERENCE = read("vibly_slip.json")
GRIDS = REFERENCE["grids"]


def rows_of(lengths):
    """Rows of 0 and 1 from run lengths, zeros first."""
    return np.array([np.repeat(np.arange(len(row)) % 2, row) for row in lengths], dtype=bool)


def row_of(lengths):
    return rows_of([lengths])[0]


class Grid:
    """States, actions, and the image of each pair by this project's map."""

    def __init__(self, grid):
        self.states = np.linspace(grid["states"]["first"], grid["states"]["last"], grid["states"]["count"])
        actions = grid["actions"]
        self.actions = np.linspace(actions["first_rad"], actions["last_rad"], actions["count"])
        self.parameters = grid["parameters"]
        self.survives = np.zeros((len(self.states), len(self.actions)), dtype=bool)
        self.next_state = np.full(self.survives.shape, np.nan)
        for pair in np.ndindex(self.survives.shape):
            step = self.step(*pair)
            self.survives[pair] = step.outcome == classic_slip.FLIES
            if self.survives[pair]:
                self.next_state[pair] = self.state_of(step)
        self.bins = np.searchsorted(self.states, self.next_state, side="right")

    def step(self, state, action):
        p = self.parameters
        mass, gravity, energy = p["mass_kg"], p["gravity_m_per_s2"], p["total_energy_J"]
        given = {"stiffness": p["stiffness_N_per_m"], "free_length": p["free_length_m"]}
        slip = classic_slip.slip(self.actions[action], mass=mass, gravity=gravity, **given)
        return classic_slip.step(slip, self.states[state] * energy / (mass * gravity), energy)

    def state_of(self, step):
        p = self.parameters
        potential = p["mass_kg"] * p["gravity_m_per_s2"] * step.next_height
        return potential / (potential + 0.5 * p["mass_kg"] * step.next_speed**2)

    def kept(self, *, from_not_failed=False):
        """Bins as boxes: both states that enclose the next one must be viable."""
        count = len(self.states)
        states, actions = np.nonzero(self.survives & ((self.bins > 0) | from_not_failed))
        bins = self.bins[states, actions]
        low, high = (np.stack([at.clip(0, count - 1), 0 * at]) for at in (bins - 1, bins))
        boxes = Boxes(states.astype(np.int32), actions.astype(np.int32), low, high)
        kept = largest_kept(boxes, (count, 1), inner=True)
        pairs = np.zeros_like(self.survives)
        pairs[states[kept.pairs], actions[kept.pairs]] = True
        assert np.array_equal(pairs.any(axis=1), kept.states[:, 0])
        return pairs, kept


@pytest.fixture(scope="module", params=GRIDS)
def grid(request):
    return GRIDS[request.param], Grid(GRIDS[request.param])


def test_the_same_pairs_fail_and_the_others_lead_into_the_same_bins(grid):
    theirs, ours = grid
    survives = rows_of(theirs["survives"])
    assert survives.size == theirs["counts"]["pairs"]
    assert np.array_equal(ours.survives, survives)
    assert ours.bins[survives].tolist() == theirs["bin"]


def test_the_same_pairs_and_states_are_viable_and_as_robust(grid):
    theirs, ours = grid
    pairs, kept = ours.kept()
    assert np.array_equal(pairs, rows_of(theirs["viable_pairs"]))
    assert np.array_equal(kept.states[:, 0], row_of(theirs["viable_states"]))
    assert pairs.sum(axis=1).tolist() == theirs["robustness_count"]
    assert kept.passes == theirs["counts"]["passes"]


def test_the_same_pairs_are_viable_if_those_below_the_grid_are_not_left_out(grid):
    theirs, ours = grid
    pairs, kept = ours.kept(from_not_failed=True)
    ending = "_from_not_failed" if "viable_pairs_from_not_failed" in theirs else ""
    assert np.array_equal(pairs, rows_of(theirs[f"viable_pairs{ending}"]))
    assert np.array_equal(kept.states[:, 0], row_of(theirs[f"viable_states{ending}"]))
    assert pairs.sum(axis=1).tolist() == theirs[f"robustness_count{ending}"]


def test_all_four_grids_are_there_and_legs_behind_the_body_are_tried():
    assert sum(grid["counts"]["pairs"] for grid in GRIDS.values()) == 17236
    behind = sum(
        rows_of(grid["survives"])[:, np.linspace(a["first_rad"], a["last_rad"], a["count"]) <= 0].sum()
        for grid in GRIDS.values()
        for a in [grid["actions"]]
    )
    assert behind == 18
