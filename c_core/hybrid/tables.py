"""Tables in C: rows by the names of members, lists, enumerations."""


def c_boolean(value):
    """A truth value of C."""
    return "true" if value else "false"


def row_in_c(row):
    """A row of a table, by names of its members."""
    return f"    {{{', '.join(f'.{name} = {value}' for name, value in row.items())}}},\n"


def rows_in_c(kind, name, rows, last):
    """A table of rows. The row behind its end keeps C from seeing an empty table."""
    return f"static const tdmf_{kind}_kind {name}[] = {{\n{''.join(rows)}    {{.{last} = -1}},\n}};\n"


def lists_in_c(kind, lists):
    """Tables of numbers or names, by their own names."""
    tables = [f"{name}[] = {{{', '.join(map(str, [*values] or [0]))}}}" for name, values in lists.items()]
    return f"static const {kind} {', '.join(tables)};\n"


def list_in_c(kind, name, values):
    """A table of numbers or names."""
    return lists_in_c(kind, {name: values})


def enumeration(prefix, names):
    """Names for the rows of a table."""
    return f"enum {{{', '.join(f'{prefix}_{name}' for name in [*names, 'COUNT'])}}};\n"
