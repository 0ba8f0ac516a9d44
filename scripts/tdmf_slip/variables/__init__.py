"""The table of a runner's variables, their units, and values for them."""
