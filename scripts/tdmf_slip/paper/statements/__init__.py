"""What this project says of its own: each claim with its control, and how it is computed.

A claim that compares two runners has its control beside it: the same comparison with the runners made equal
in what else could do it. Numbers that are drawn depend on the seed; their intervals are wide enough for any.
"""
