"""Numerical methods that know nothing of runners: Newton's method, walks by steps, and curves."""
