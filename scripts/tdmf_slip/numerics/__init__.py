"""Numerical methods that know nothing of runners: Newton's method with damping, and walks by halves."""
