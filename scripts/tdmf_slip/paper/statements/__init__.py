"""Claims of this project: one module for each section of the page of results.

A claim that compares two runners has a control: the same comparison with runners that are equal in every
other possible cause. A claim must hold at any seed.
"""
