"""Runners fitted to measured gaits, with confidence intervals and combinations that cannot be identified."""
