"""The paper's figures and our own, one module per figure; `catalogue` lists all of them."""

from ... import pictures  # noqa: F401 # reports a missing Matplotlib before a figure imports it
