"""Numerical methods that know nothing of runners: Newton's method, and curves that are followed."""
