"""The equations of the runner, once: plain functions over any number type, a page a topic.

A law takes numbers and records of numbers, and gives a number or a record. It calls nothing but + - * / and
`functions`, and it never looks at a number to decide: what a case depends on (contact, phase, a clamp) is
handed in as a word or a truth value. So the same text serves floats, intervals, Taylor series and the
expressions that `derive` makes C of.

Equation numbers are those of Or and Moravia, Int. J. Adv. Robot. Syst. 13:69 (2016). The names of a
record's members are those of the C structs that `c_core/include` declares.
"""
