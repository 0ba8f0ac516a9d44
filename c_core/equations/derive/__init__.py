"""Traces laws into expressions, by Python's standard library alone."""
