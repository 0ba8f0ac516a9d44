"""What this project says of its own: a module for each section of the page of results.

A claim that compares two runners has its control beside it: the same comparison with the runners made equal
in what else could do it. What it says must be true at any seed.
"""
