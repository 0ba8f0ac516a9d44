"""Pages of users' own, built once for all tests, and loaded."""

import shutil

import tdmf_slip
from conftest import ROOT, locked
from tdmf_slip.building.build import derived
from tdmf_slip.building.sources import page_in
from tdmf_slip.builds import TABLE

BUILT = ROOT / "build" / "own_pages"


def loaded(path, cache={}):  # noqa: B006
    """The model of the page in a file, built where no earlier test has built it."""
    if path not in cache:
        page = page_in(path)
        table, _ = derived(page)
        folder = BUILT / f"{table['c_name']}-{table['id']}"
        with locked("own_pages"):
            if not (folder / TABLE).exists():
                for old in BUILT.glob(f"{table['c_name']}-*"):
                    shutil.rmtree(old)
                tdmf_slip.build(page, folder, unit=False)
        cache[path] = tdmf_slip.load_model(folder)
    return cache[path]
