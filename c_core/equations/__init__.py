"""The runner's laws as plain functions over any number type, a file a topic, for proofs and peers.

The core runs the page in `c_core/pages`. These functions are a formulation of their own, so that proofs by
interval arithmetic do not rest on the page; a test compares both. A law calls nothing but + - * / and
`functions`, and never looks at a number to decide: a case (contact, phase, a clamp) is a word or a truth
value.

Equation numbers are those of Or and Moravia, Int. J. Adv. Robot. Syst. 13:69 (2016).
"""
