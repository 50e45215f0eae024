"""What Python gives a kernel is taken in once: tables' columns stay the same arrays from tick to tick.

numba reads every array of every call anew, a hundred and more of them in the scene of a mind, each an object that lies
in cold memory by then. Here a kernel that is given words of memory leaves there what it read, beside the object that
it read it from, and looks no further where it is given that very object again. That holds for whole tuples and for
each array within one that is new. An array's elements are read in any case; what may not change is where they lie.
"""

from collections.abc import Iterable
from typing import Any, Final

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.callwrapper import PyCallWrapper
from numba.core.compiler_machinery import register_pass
from numba.core.lowering import Lower
from numba.core.typed_passes import NativeParforLowering
from numba.np import arrayobj
from numba.parfors.parfor_lowering import ParforLower

_WORD: Final = ir.IntType(64)
_KEPT: Final = (types.BaseTuple, types.Array)
"""The types whose objects are known again."""


def _leaves(context: Any, kind: Any) -> tuple[Any, ...]:
    """Return LLVM's types of the values of which one of `kind` is made."""
    leaves: tuple[Any, ...] = context.get_arg_packer([kind]).argument_types
    return leaves


def words_of(context: Any, kinds: Iterable[Any]) -> int:
    """Return how many words of memory arguments of these types take: one a value, one an object that is known again."""
    return sum(
        1 + words_of(context, kind)
        if isinstance(kind, types.BaseTuple)
        else isinstance(kind, types.Array) + len(_leaves(context, kind))
        for kind in kinds
    )


class _Reader:
    """Writes the code that reads arguments into words."""

    def __init__(
        self, context: Any, builder: Any, api: Any, words: Any, kept: Any, failed: Any
    ) -> None:
        """Take the words' address, the list that keeps objects alive or a null, and the block that ends in an error."""
        self._context, self._builder, self._api = context, builder, api
        self._words, self._kept, self._failed = words, kept, failed
        self._free = 0

    def read(self, kind: Any, given: Any) -> list[int]:
        """Read an argument of a type; return at which words its values lie."""
        if not isinstance(kind, _KEPT):
            return self._read_value(kind, given)
        builder, at = self._builder, self._free
        self._free += 1
        known = self._word(at, given.type)
        with builder.if_then(builder.icmp_unsigned("!=", builder.load(known), given)):
            # Until all of it is read, it is no object's.
            builder.store(ir.Constant(given.type, None), known)
            places = self._read_inside(kind, given)
            builder.store(given, known)
            self._keep(at, given)
        return places

    def value(self, kind: Any, places: list[int]) -> Any:
        """Return the argument whose values lie at these words."""
        leaves = [
            self._builder.load(self._word(at, leaf))
            for at, leaf in zip(places, _leaves(self._context, kind), strict=True)
        ]
        return self._context.get_arg_packer([kind]).from_arguments(self._builder, leaves)[0]

    def _read_inside(self, kind: Any, given: Any) -> list[int]:
        if isinstance(kind, types.Array):
            return self._read_value(kind, given)
        size = self._api.tuple_size(given)
        right = self._builder.icmp_signed("==", size, ir.Constant(size.type, len(kind)))
        with cgutils.if_unlikely(self._builder, self._builder.not_(right)):
            text = f"size mismatch for tuple, expected {len(kind)} element(s) but got %zd"
            self._api.err_format("PyExc_ValueError", text, size)
            self._builder.branch(self._failed)
        parts = [self.read(part, self._api.tuple_getitem(given, k)) for k, part in enumerate(kind)]
        return [at for places in parts for at in places]

    def _read_value(self, kind: Any, given: Any) -> list[int]:
        """Read what is no tuple. An array is left without numba's count of references: the object is kept alive."""
        context, builder = self._context, self._builder
        native = self._api.to_native_value(kind, given)
        with cgutils.if_unlikely(builder, native.is_error):
            builder.branch(self._failed)
        value = native.value
        if isinstance(kind, types.Array):
            array = arrayobj.make_array(kind)(context, builder, value)
            array.meminfo = ir.Constant(array.meminfo.type, None)
            array.parent = ir.Constant(array.parent.type, None)
            value = array._getvalue()
        leaves = context.get_arg_packer([kind]).as_arguments(builder, [value])
        places = list(range(self._free, self._free + len(leaves)))
        self._free += len(leaves)
        for at, leaf in zip(places, leaves, strict=True):
            builder.store(leaf, self._word(at, leaf.type))
        if native.cleanup is not None:
            native.cleanup()
        if context.enable_nrt:
            context.nrt.decref(builder, kind, native.value)
        return places

    def _word(self, at: int, kind: Any) -> Any:
        """Return the address of a word that holds a value of an LLVM type."""
        place = self._builder.gep(self._words, [ir.Constant(ir.IntType(32), at)])
        return self._builder.bitcast(place, kind.as_pointer())

    def _keep(self, at: int, given: Any) -> None:
        """Keep an object alive, or a new one may come to lie where it lay."""
        with self._builder.if_then(cgutils.is_not_null(self._builder, self._kept)):
            self._api.incref(given)
            self._api.list_setitem(self._kept, self._api.py_ssize_t(at + 1), given)


class Entry(PyCallWrapper):  # type: ignore[misc]  # numba is untyped
    """What Python calls: it reads the arguments and runs the kernel.

    After the arguments may come a list: address of zeroed words, then room for an object a word. Else nothing is kept.
    """

    def build_wrapper(self, api: Any, builder: Any, _closure: Any, args: Any, _kws: Any) -> None:
        """Write its code."""
        kinds = self.fndesc.argtypes
        failed = builder.append_basic_block("failed")
        with builder.goto_block(failed):
            builder.ret(api.get_null_object())
        given = [cgutils.alloca_once_value(builder, api.get_null_object()) for _ in (*kinds, None)]
        least, most = len(kinds), len(kinds) + 1
        parsed = api.unpack_tuple(args, self.fndesc.qualname, least, most, *given)
        with cgutils.if_unlikely(builder, cgutils.is_null(builder, parsed)):
            builder.branch(failed)
        *objects, kept = (builder.load(place) for place in given)
        reader = _Reader(self.context, builder, api, self._words(api, builder, kept), kept, failed)
        places = [
            None if isinstance(kind, types.Omitted) else reader.read(kind, thing)
            for kind, thing in zip(kinds, objects, strict=True)
        ]
        values = [
            None if at is None else reader.value(kind, at)
            for kind, at in zip(kinds, places, strict=True)
        ]
        self._run(api, builder, values)

    def _words(self, api: Any, builder: Any, kept: Any) -> Any:
        """Return the address of the words: those of the list, else some on the stack."""
        room = words_of(self.context, self.fndesc.argtypes)
        words = cgutils.alloca_once(builder, _WORD.as_pointer())
        with builder.if_else(cgutils.is_not_null(builder, kept)) as (lasting, passing):
            with lasting:
                address = api.long_as_voidptr(api.list_getitem(kept, 0))
                builder.store(builder.bitcast(address, _WORD.as_pointer()), words)
            with passing:
                fresh = cgutils.alloca_once(builder, ir.ArrayType(_WORD, room), zfill=False)
                cgutils.memset(builder, fresh, ir.Constant(_WORD, 8 * room), 0)
                builder.store(builder.bitcast(fresh, _WORD.as_pointer()), words)
        return builder.load(words)

    def _run(self, api: Any, builder: Any, values: list[Any]) -> None:
        """Run the kernel and return what it does, as numba's wrapper has it."""
        status, answer = self.context.call_conv.call_function(
            *(builder, self.func, self.fndesc.restype, self.fndesc.argtypes, values),
            attrs=("noinline",),
        )
        with builder.if_then(status.is_ok, likely=True):
            with builder.if_then(status.is_none):
                api.return_none()
            kind = self._simplified_return_type()
            builder.ret(api.from_native_return(kind, answer, self.get_env(api, builder)))
        self.context.call_conv.raise_error(builder, api, status)
        builder.ret(api.get_null_object())


class EntryLowering(Lower):  # type: ignore[misc]  # numba is untyped
    """numba's lowering, with an `Entry` for wrapper."""

    def create_cpython_wrapper(self, release_gil: bool = False) -> None:
        """Add the wrapper to the kernel's library."""
        context, fndesc = self.context, self.fndesc
        module = context.create_module("wrapper")
        kind = context.call_conv.get_function_type(fndesc.restype, fndesc.argtypes)
        callee = ir.Function(module, kind, fndesc.llvm_func_name)
        Entry(context, module, callee, fndesc, self.env, self.call_helper, release_gil).build()
        self.library.add_ir_module(module)


class _EntryParforLowering(ParforLower, EntryLowering):  # type: ignore[misc]  # numba is untyped
    """The same of what is parallel."""


@register_pass(mutates_CFG=True, analysis_only=False)
class LowerParallel(NativeParforLowering):  # type: ignore[misc]  # numba is untyped
    """numba's pass that makes LLVM's code of a parallel kernel."""

    _name = "lower_parallel"

    @property
    def lowering_class(self) -> type:
        """The class that does it."""
        return _EntryParforLowering
