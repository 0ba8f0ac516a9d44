"""Viable sets: states from which some choice of actions avoids a fall for ever.

Heim and Badri-Sproewitz, Beyond Basins of Attraction: Quantifying Robustness of Natural Dynamics, IEEE
Transactions on Robotics 2019, doi 10.1109/TRO.2019.2910739.
"""
