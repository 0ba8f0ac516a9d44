"""The paper's figures, remade, and what it could not show. One module per figure; `catalogue` has all."""

from ... import pictures  # noqa: F401 # it says what is missing where Matplotlib is
