"""Other ways to run the same stride, written as their own users would: what the benchmark compares with."""
