"""A preview of a region of attraction: the exact map's fates near every border, by far fewer strides."""

import numpy as np
import pytest
import tdmf_slip
import xarray
from conftest import some_of
from tdmf_slip import InputError
from tdmf_slip.analysis.preview import LARGEST_SQUARE, preview_of

AXES = {"com_height": None, "com_speed": None}


def followed(fates):
    """A preview of fates that are known, and how many starts it asked for."""
    strides = 1 + np.arange(fates.size, dtype="i4").reshape(fates.shape)
    asked = np.zeros(fates.shape, dtype=int)

    def follow(rows, columns):
        np.add.at(asked, (rows, columns), 1)
        return np.stack([fates[rows, columns], strides[rows, columns]])

    return preview_of(fates.shape, follow), asked


@pytest.mark.parametrize("shape", [(200, 170), (33, 16), (17, 2), (1, 40), (1, 1), (2, 1), (129, 3)])
def test_a_disc_is_painted_as_it_is(shape):
    """Its border is nowhere bent as sharply as a square is wide; no start is followed twice.

    Of a map of one fate only corners of the first squares are.
    """
    uniform, _ = followed(np.full((161, 161), 3, dtype="i4"))
    assert (uniform.fate == 3).all() and uniform.is_followed.sum() == 11 * 11
    rows, columns = np.indices(shape)
    disc = (np.hypot(rows - 90.3, columns - 80.7) < 55.0).astype("i4")
    found, asked = followed(disc)
    np.testing.assert_array_equal(found.fate, disc)
    np.testing.assert_array_equal(asked, found.is_followed)
    if min(shape) > 100:
        assert found.is_followed.mean() < 0.2


@pytest.mark.parametrize("corner", [(1, 1), (7, 9), (40, 33)])
def test_an_island_as_wide_as_a_square_is_found_and_a_smaller_one_may_be_missed(corner):
    row, column = corner
    for width, is_found in ((LARGEST_SQUARE, True), (LARGEST_SQUARE // 2 - 2, corner != (1, 1) and None)):
        fates = np.zeros((100, 100), dtype="i4")
        fates[row : row + width, column : column + width] = 1
        found, _ = followed(fates)
        if is_found is not None:
            assert (found.fate == fates).all() == is_found


@pytest.mark.parametrize("friction", some_of([1.2, 10.0], 1))
def test_a_preview_is_the_exact_map_where_a_border_crosses_it(friction):
    """The border is the exact map's, found by less than half of the strides."""
    exact = tdmf_slip.basin({"ground.friction": friction}, AXES, n=64)
    preview = tdmf_slip.basin({"ground.friction": friction}, AXES, n=64, refine="preview")
    assert len(np.unique(exact["fate"])) > 1
    assert (preview["fate"] != exact["fate"]).mean() < 2e-3
    is_followed = preview["is_followed"].values == 1
    strides = exact["strides_until_known"].values
    np.testing.assert_array_equal(preview["strides_until_known"].values[is_followed], strides[is_followed])
    assert strides[is_followed].sum() < 0.45 * strides.sum()


def test_a_preview_is_the_same_on_file_and_kept_apart_from_the_exact_map(tmp_path):
    runner, path = {"ground.friction": 10.0}, tmp_path / "map.nc"
    one = tdmf_slip.basin(runner, AXES, n=20, refine="preview")
    two = tdmf_slip.basin(runner, AXES, n=20, refine="preview", path=path)
    xarray.testing.assert_identical(one, two)
    again = tdmf_slip.basin(runner, AXES, n=20, refine="preview", path=path)
    xarray.testing.assert_equal(again, one)
    with pytest.raises(InputError, match="another refine"):
        tdmf_slip.basin(runner, AXES, n=20, path=path)


def test_the_command_tells_how_many_starts_were_followed(command, tmp_path):
    options = ("--friction", 10, "--n", 40, "--refine", "preview", "--samples", 0)
    found = command.json("basin", *options, "--plot", tmp_path / "map.png")
    assert 0 < found["followed"] < found["starts"] == 1600
    assert (tmp_path / "map.png").stat().st_size > 10_000
