"""Runners fitted to measured gaits: parameters with their confidence, and what the data do not tell."""
