"""Rows of a result in their NetCDF file: written where they belong, and nothing else."""

import numpy as np
import pytest
import xarray
from tdmf_slip import InputError
from tdmf_slip.files.netcdf import read_dataset, write_dataset
from tdmf_slip.files.rows import RowFile


def blank():
    """Variables of several types, sizes that are padded, attributes of all kinds."""
    data = xarray.Dataset(
        {
            "strides": (("height", "speed"), np.zeros((5, 3), "i4")),
            "share": (("height", "speed"), np.full((5, 3), np.nan)),
            "fate": (("height", "speed"), np.full((5, 3), -1, "i4")),
            "small": ("speed", np.array([1, 2, 3], "i1")),
        },
        coords={"height": np.linspace(1.0, 2.0, 5), "speed": [0.5, 1.0, 1.5]},
    )
    data["fate"].attrs = {"flag_values": np.arange(7), "flag_meanings": "settled fell"}
    data.attrs = {"word": "+0-", "größe": "mü", "gait": 1.25, "points": 10_000}
    return data


def filled(data, rows):
    for row in rows:
        data["strides"].values[row] = 10 * row + np.arange(3)
        data["share"].values[row] = 0.1 * row
        data["fate"].values[row] = [0, 1, 0]


def test_a_row_is_written_at_its_offset_and_no_other_byte_changes(tmp_path):
    path, data = tmp_path / "größe.nc", blank()
    file = RowFile(path, data)
    assert read_dataset(path).identical(blank())
    before = path.read_bytes()
    filled(data, range(5))
    file.write(("strides", "share", "fate"), (1, 4))
    after = path.read_bytes()
    assert len(after) == len(before)
    changed = sum(one != other for one, other in zip(before, after, strict=True))
    assert 0 < changed <= 2 * 3 * (4 + 8 + 4)
    expected = blank()
    filled(expected, (1, 4))
    assert read_dataset(path).identical(expected)
    assert xarray.load_dataset(path).identical(expected)


def test_a_file_is_gone_on_with_and_one_of_another_format_made_anew(tmp_path):
    path, data = tmp_path / "map.nc", blank()
    filled(data, (0,))
    write_dataset(path, data)
    assert not path.read_bytes().startswith(b"CDF")
    RowFile(path, data).write(("fate",), ())
    kept = path.stat().st_ino
    assert path.read_bytes().startswith(b"CDF") and read_dataset(path).identical(data)
    filled(data, (3,))
    RowFile(path, data).write(("strides", "share", "fate"), (3,))
    assert path.stat().st_ino == kept and read_dataset(path).identical(data)


def test_a_file_that_is_gone_is_told(tmp_path):
    file = RowFile(tmp_path / "map.nc", blank())
    (tmp_path / "map.nc").unlink()
    with pytest.raises(InputError, match=r"map\.nc: cannot be written: No such file"):
        file.write(("fate",), (0,))
