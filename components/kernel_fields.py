"""Fields of a kernel's tuple arguments are read once, where it begins: `crowd.x[i]` reads a place of one array.

numba reads the whole tuple at every use of a field, hundreds of numbers for the scene of a mind, from a place in memory
that LLVM then takes apart again, for seconds. What never changes needs no such place.

Nor does an index count from an array's end here unless it is a constant: to ask costs a tenth of a mind's time, and
keeps LLVM from doing several at once.
"""

from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Final

from llvmlite.ir import Constant
from numba.core import ir, types
from numba.core.analysis import must_use_alloca
from numba.core.compiler_machinery import FunctionPass, register_pass
from numba.core.ir_utils import build_definitions, replace_vars
from numba.core.typed_passes import NativeLowering
from numba.np import arrayobj

from components.kernel_arguments import EntryLowering

_Path = tuple[int | str, ...]
"""Where a value stands: number of the argument, then the names of fields within fields."""

_FIELD: Final = "$field."


class _Paths:
    """Which variables hold an argument or a field of one, under whatever name."""

    def __init__(self, blocks: dict[int, Any], arguments: tuple[Any, ...]) -> None:
        self._definitions = build_definitions(blocks)
        self._arguments = arguments
        self._known: dict[str, tuple[_Path, Any] | None] = {}

    def of(self, name: str) -> tuple[_Path, Any] | None:
        """Return path and type of what the variable always holds, None where that is no field."""
        if name not in self._known:
            self._known[name] = None
            definitions = self._definitions.get(name, ())
            if len(definitions) == 1:
                self._known[name] = self._find(definitions[0])
        return self._known[name]

    def _find(self, value: Any) -> tuple[_Path, Any] | None:
        if isinstance(value, ir.Arg):
            return (value.index,), self._arguments[value.index]
        if isinstance(value, ir.Var):
            return self.of(value.name)
        if not (isinstance(value, ir.Expr) and value.op == "getattr"):
            return None
        whole = self.of(value.value.name)
        if whole is None or not isinstance(whole[1], types.NamedTuple):
            return None
        path, kind = whole
        if value.attr not in kind.fields:
            return None
        return (*path, value.attr), kind.types[kind.fields.index(value.attr)]


class _Reads:
    """Assignments, at the kernel's beginning, of the fields that it needs."""

    def __init__(self, first: Any, arguments: dict[int, Any]) -> None:
        self._first = first
        self._variables: dict[_Path, Any] = {(at,): name for at, name in arguments.items()}
        self.assignments: list[Any] = []

    def variable(self, path: _Path) -> Any:
        """Return the variable that holds the field; what it is a field of is read before it."""
        if path not in self._variables:
            loc = self._first.loc
            value = ir.Expr.getattr(self.variable(path[:-1]), path[-1], loc)
            fresh = ir.Var(self._first.scope, _FIELD + ".".join(map(str, path)), loc)
            self.assignments.append(ir.Assign(value, fresh, loc))
            self._variables[path] = fresh
        return self._variables[path]


def read_fields_once(blocks: dict[int, Any], arguments: tuple[Any, ...]) -> bool:
    """Let the blocks of a function, whose arguments have these types, read fields at its beginning; say if any do."""
    first = blocks[min(blocks)]
    given = [
        at
        for at, line in enumerate(first.body)
        if isinstance(line, ir.Assign) and isinstance(line.value, ir.Arg)
    ]
    paths, fields = _Paths(blocks, arguments), {}
    for block in blocks.values():
        kept = []
        for line in block.body:
            found = paths.of(line.target.name) if isinstance(line, ir.Assign) else None
            if found is None or isinstance(line.value, ir.Arg):
                kept.append(line)
            else:
                fields[line.target.name] = found[0]
        block.body = kept
    if not fields:
        return False
    reads = _Reads(first, {first.body[at].value.index: first.body[at].target for at in given})
    used = {v.name for block in blocks.values() for line in block.body for v in line.list_vars()}
    replace_vars(
        blocks, {name: reads.variable(path) for name, path in fields.items() if name in used}
    )
    after = given[-1] + 1
    first.body[after:after] = reads.assignments
    return True


@register_pass(mutates_CFG=False, analysis_only=False)
class FieldsOnce(FunctionPass):  # type: ignore[misc]  # numba is untyped
    """numba's pass that does it, before types are inferred."""

    _name = "fields_once"

    def __init__(self) -> None:
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> bool:
        """Change the function; say whether it was."""
        changed = read_fields_once(state.func_ir.blocks, state.args)
        if changed:
            state.func_ir._definitions = build_definitions(state.func_ir.blocks)
        return changed


@contextmanager
def _counted_from_the_front() -> Iterator[None]:
    """Let computed indices be offsets as they are, where numba would ask of each whether it counts from the end."""
    numbas = arrayobj.fix_integer_index

    def offset(context: Any, builder: Any, kind: Any, index: Any, size: Any) -> Any:
        if isinstance(index, Constant):
            return numbas(context, builder, kind, index, size)
        return context.cast(builder, index, kind, types.intp if kind.signed else types.uintp)

    arrayobj.fix_integer_index = offset
    try:
        yield
    finally:
        arrayobj.fix_integer_index = numbas


class _LowerWithoutPlaces(EntryLowering):
    """Keeps arguments and their fields as values, where numba would keep what several blocks read in memory."""

    def lower(self) -> None:
        """Make LLVM's code; an index below 0 that is no constant is out of bounds."""
        with _counted_from_the_front():
            super().lower()

    def _find_singly_assigned_variable(self) -> None:
        super()._find_singly_assigned_variable()
        lines = [line for block in self.blocks.values() for line in block.find_insts(ir.Assign)]
        times = Counter(line.target.name for line in lines)
        for line in self.blocks[min(self.blocks)].find_insts(ir.Assign):
            name = line.target.name
            if times[name] == 1 and (name.startswith(_FIELD) or isinstance(line.value, ir.Arg)):
                self._singly_assigned_vars.add(name)
        self._singly_assigned_vars -= set(must_use_alloca(self.blocks))


@register_pass(mutates_CFG=True, analysis_only=False)
class LowerFields(NativeLowering):  # type: ignore[misc]  # numba is untyped
    """numba's pass that makes LLVM's code, for a function whose fields are read once."""

    _name = "lower_fields"

    @property
    def lowering_class(self) -> type:
        """The class that does it."""
        return _LowerWithoutPlaces
