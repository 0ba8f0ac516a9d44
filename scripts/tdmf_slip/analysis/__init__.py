"""Analyses of many gaits: ranges, grids, branches with borders and bifurcations, regions of attraction."""
