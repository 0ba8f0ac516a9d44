"""Optimal runners: parameters within bounds whose gait has the least or the most of a quantity."""
