"""C99 text: safe names, expressions, statements, functions, wrapped lines."""

import re
from collections import Counter

from .expressions import ordered

WIDTH = 110
C_WORDS = """auto break case char const continue default do double else enum extern float for goto if
    inline int long register restrict return short signed sizeof static struct switch typedef union
    unsigned void volatile while bool true false complex imaginary"""
CPP_WORDS = """alignas alignof and and_eq asm bitand bitor catch class compl constexpr const_cast decltype
    delete dynamic_cast explicit export friend mutable namespace new noexcept not not_eq nullptr operator
    or or_eq private protected public reinterpret_cast static_assert static_cast template this
    thread_local throw try typeid typename using virtual wchar_t xor xor_eq"""
MACROS = """NULL NAN INFINITY HUGE_VAL EOF I assert errno stdin stdout stderr signbit isnan isinf isfinite
    isnormal fpclassify near far small interface unix linux min max huge pascal cdecl offsetof va_arg
    setjmp DOMAIN OVERFLOW UNDERFLOW"""
OWN_WORDS = """real mask interval select any broadcast power order series constants p x y dp dx dy c d s t
    g k i j by sum next span outputs low high counted value parameters states d_parameters d_states after
    given of_states of_events varied tables seed watched at d_at TERMS KERNEL"""
FUNCTIONS = """sin cos exp log expm1 log1p atan2 sqrt fabs memset memcpy product product_of product_so_far
    square_of quotient_of root_of own_root_of drift_times exp_of log_of sine_and_cosine sine_and_cosine_of
    sine_and_cosine_by_rate constant_of with_constant rough_root first_root moving"""
RESERVED = set(f"{C_WORDS} {CPP_WORDS} {MACROS} {OWN_WORDS} {FUNCTIONS}".split())
"""Words of C, C++ and MSVC, macros of headers, and names of the generator; a quantity so named gets a `_`."""


def safe_names(names):
    """A name in C for each name of a page: the same name, with `_` appended if it may be reserved or a macro.

    Names that begin with `real_` are those of the kernel, by macros.
    """
    found, taken = {}, set(RESERVED)
    for name in names:
        new = f"own_{name}" if name.startswith("real_") else name + "_" * name.isupper()
        while new in taken or (new != name and new in names):
            new += "_"
        taken.add(new)
        found[name] = new
    return found


PRECEDENCE = {"+": 1, "-": 1, "*": 2, "/": 2, "negative": 3}


def number_text(value):
    """A number in C."""
    if float(value) != value and value.denominator <= 1000:
        return f"({float(value.numerator)!r} / {float(value.denominator)!r})"
    return repr(float(value))


def c_text(expression, text_of=lambda node: None):
    """An expression in C; `text_of` gives the variable of a node that has one, else None."""
    known, written = _Texts(text_of), {}
    for node in ordered([expression], known):
        if node in known:
            written[node] = known[node], 4
        elif node.operation == "number":
            written[node] = number_text(node.value), 4 if node.value >= 0 else 3
        else:
            written[node] = _operation(node, [written[o] for o in node.operands])
    return written[expression][0]


def real_text(expression, text_of=lambda node: None):
    """An expression in C of the type `real`, which a number has to be made."""
    text = c_text(expression, text_of)
    return f"broadcast({text})" if expression.operation == "number" else text


class _Texts(dict):
    """Variables and symbols by node; each node is looked up once."""

    def __init__(self, text_of):
        super().__init__()
        self.text_of = text_of

    def __contains__(self, node):
        if node not in self.keys():
            self[node] = self.text_of(node) or (str(node.value) if node.operation == "symbol" else None)
        return self[node] is not None


def _operation(node, operands):
    mine = PRECEDENCE.get(node.operation, 4)
    texts = [text for text, _ in operands]
    if node.operation == "negative":
        return f"-{_enclosed(operands[0], 3)}", 3
    if node.operation in PRECEDENCE:
        return f"{_enclosed(operands[0], mine)} {node.operation} {_enclosed(operands[1], mine + 1)}", mine
    if node.operation == "select":
        return f"select({texts[0]} {node.value} {texts[1]}, {texts[2]}, {texts[3]})", 4
    if node.operation in ("looked_up", "variation_looked_up"):
        (table, column), seed = node.value, "seed, " if node.operation == "variation_looked_up" else ""
        text = f"{node.operation}(tables, TABLE_{table}, COLUMN_{table}_{column}, {seed}{', '.join(texts)})"
        return text, 4
    return f"real_{node.operation}({', '.join(texts)})", 4


def _enclosed(operand, least):
    text, precedence = operand
    return text if precedence >= least else f"({text})"


def place_to_break(line, after):
    """Place to break a line of C: after a comma or before an operator, else at any space; -1 for none."""
    good = [m.start() for m in re.finditer(r"(?<=,) | (?=[-+?:] )", line[: WIDTH + 1]) if m.start() > after]
    return good[-1] if good else line.rfind(" ", after + 1, WIDTH + 1)


def wrapped(line):
    """A line of C, broken into lines of at most WIDTH characters."""
    if len(line) <= WIDTH:
        return line
    indent, lines = len(line) - len(line.lstrip()), []
    more = " " * (indent + 4)
    is_comment = line.lstrip().startswith("/*")
    while len(line) > WIDTH:
        at = line.rfind(" ", indent + 4, WIDTH) if is_comment else place_to_break(line, indent + 20)
        if at < 0 or not line[:at].strip():
            break
        lines.append(line[:at])
        line = (" " * indent + " * " if is_comment else more) + line[at + 1 :]
    return "\n".join([*lines, line])


def wrapped_text(text):
    """All lines of a text wrapped."""
    return "\n".join(wrapped(line) for line in text.split("\n"))


def lines_of(lines, indent="    "):
    """Lines of C with an indent."""
    return "".join(f"{indent}{line}\n" for line in lines)


def declared_in_c(of, names, size=""):
    """Variables or members of a type, such as arrays of a size."""
    return f"{of} {', '.join(f'{name}{size}' for name in names)};"


def comment(text):
    """A comment of C, or nothing where there is no text."""
    return f"/* {' '.join(text.split())} */\n" if text else ""


def function_in_c(result, name, given, body, about, structs):
    """A function of C. `structs` gives the variable, type and `const` by which it reads an array."""
    begin, unused = "", []
    for argument in re.findall(r"(\w+)(?:,|$)", given):
        variable, struct, const = structs.get(argument, ("", "", ""))
        if variable and re.search(rf"\b{variable}->", body):
            begin += f"    {const}{struct} *{variable} = ({const}void *){argument};\n"
        elif not re.search(rf"\b{argument}\b", body):
            unused.append(f"(void){argument}")
    begin += f"    {', '.join(unused)};\n" if unused else ""
    return f"{comment(about)}static {result} {name}({given}) {{\n{begin}{body}}}\n"


NAMES = {"*": "_times_", "/": "_over_", "+": "_plus_", "-": "_minus_", "negative": "minus_", "select": "_or_"}
SHORT_NAMES = {"*": "product", "/": "ratio", "+": "sum", "-": "sum"}


def name_of(node):
    """The name of an expression on the page, else a name composed of its operands' names."""
    own, names = _Texts(_own_name), {}
    for part in ordered([node], own):
        of = [names[o] for o in part.operands[-2:]] if part not in own else []
        word = NAMES.get(part.operation, f"{part.operation}_of_")
        if part.operation == "/" and part.operands[0].is_number(1):
            of, word = of[1:], "inverse_"
        text = own[part] or (word.join(of) if len(of) > 1 else word + of[0])
        names[part] = text if not of or len(text) < 40 else SHORT_NAMES.get(part.operation, part.operation)
    return names[node]


def _own_name(node):
    if node.operation == "symbol":
        return node.value.replace("->", ".").split(".")[-1]
    if node.operation == "number":
        return "by_" + re.sub(r"\W", "_", f"{float(node.value):.4g}".replace("-", "minus_"))
    if node.operation in ("looked_up", "variation_looked_up"):
        return node.name or ("" if node.operation == "looked_up" else "d_") + node.value[1]
    return node.name


def take_name(node, taken):
    """Keep the name of an expression if it is free, else give it another one; `taken` receives the name."""
    if node.name is None or node.name in taken or node.name in RESERVED:
        node.name = own_name(node, taken)
    taken.add(node.name)


def own_name(node, taken):
    """A name that is not in use yet; `taken` receives it."""
    name = base = name_of(node)
    count = 1
    while name in taken or name in RESERVED:
        count += 1
        name = f"{base}_{count}"
    taken.add(name)
    return name


def uses_of(roots, known=()):
    """Number of times that each expression is an operand, without the operands of `known`."""
    return Counter(o for node in ordered(roots, known) if node not in known for o in node.operands)


def statements(roots, taken, used_names, indent="    ", used=None):
    """Variables of C for expressions that have a name or are used twice; `taken` receives them."""
    nodes, lines = ordered(roots, taken), ""
    used = used or uses_of(roots, taken)
    for node in nodes:
        if node.operands and node not in taken and (node.name or used[node] > 1):
            text = c_text(node, taken.get)
            taken[node] = own_name(node, used_names)
            lines += f"{indent}const real {taken[node]} = {text};\n"
    return lines


def assigned(values, into, indent="    "):
    """Statements that assign values to members."""
    taken = {}
    lines = statements(list(values.values()), taken, set(), indent)
    texts = {name: c_text(value, taken.get) for name, value in values.items()}
    return lines + lines_of([f"{into}{name} = {text};" for name, text in texts.items()], indent)
