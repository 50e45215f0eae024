"""How kernels call kernels: what a kernel needs as a callee is compiled, and no more (FINDINGS 5).

numba makes of every function machine code and a wrapper for Python, though most kernels are only ever called by
kernels, whose own machine code holds them: that was half of a first launch. Here a callee is kept as LLVM's
intermediate code; one that Python calls too is compiled for it when it does.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import llvmlite.binding
from numba.core import ir, types
from numba.core.caching import CompileResultCacheImpl
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler, CompileResult, DefaultPassBuilder
from numba.core.compiler_machinery import register_pass
from numba.core.registry import CPUDispatcher
from numba.core.typed_passes import NativeLowering, NativeParforLowering
from numba.core.untyped_passes import InlineInlinables

from components.kernel_arguments import LowerParallel, words_of
from components.kernel_fields import FieldsOnce, LowerFields


class _CalleeLibrary(JITCodeLibrary):  # type: ignore[misc]  # numba is untyped
    """The intermediate code of a callee with all that it calls; nothing of it runs by itself."""

    def _optimize_final_module(self) -> None:
        """Leave that to the caller, who optimises the whole."""

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._finalized = True

    def serialize_using_object_code(self) -> tuple[str, bytes]:
        """Return what the cache keeps: there is no object code."""
        return self.name, self._final_module.as_bitcode()

    @classmethod
    def of(
        cls, codegen: Any, name: str, bitcode: bytes, reload_init: list[Callable[[], None]]
    ) -> "_CalleeLibrary":
        """Return the library that was serialized. Callers, too, must run `reload_init`: it starts threads."""
        library = cls(codegen, name)
        library._reload_init.update(reload_init)
        library._final_module = llvmlite.binding.parse_bitcode(bitcode)
        library._finalized = True
        return library


@contextmanager
def _scopes_uncopied() -> Iterator[None]:
    """Let copies of a block share their function's names, all of which numba would copy with each block."""
    before = vars(ir.Scope).get("__deepcopy__")
    ir.Scope.__deepcopy__ = lambda scope, _: scope
    try:
        yield
    finally:
        if before is None:
            del ir.Scope.__deepcopy__
        else:
            ir.Scope.__deepcopy__ = before


@register_pass(mutates_CFG=True, analysis_only=False)
class _Merge(InlineInlinables):  # type: ignore[misc]  # numba is untyped
    """numba's pass that takes `merged` functions in."""

    _name = "merge"

    def run_pass(self, state: Any) -> bool:
        """Change the function; say whether it was."""
        with _scopes_uncopied():
            return bool(super().run_pass(state))


class _KernelCompiler(Compiler):  # type: ignore[misc]  # numba is untyped
    """numba's compiler, which reads fields of tuples once where nothing is parallel."""

    def define_pipelines(self) -> Any:
        """Return numba's passes and ours."""
        passes = DefaultPassBuilder.define_nopython_pipeline(self.state)
        ours = {NativeParforLowering: LowerParallel}
        if not self.state.flags.auto_parallel.enabled:
            passes.add_pass_after(FieldsOnce, InlineInlinables)
            ours = {InlineInlinables: _Merge, NativeLowering: LowerFields}
        passes.passes = [(ours.get(step, step), why) for step, why in passes.passes]
        passes.finalize()
        return [passes]


class _CalleeCompiler(_KernelCompiler):
    """... stopped before the code runs."""

    def define_pipelines(self) -> Any:
        """Return the passes of any kernel."""
        state = self.state
        state.flags.no_compile = True
        state.library = _CalleeLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        return super().define_pipelines()


class CalleeCacheImpl(CompileResultCacheImpl):  # type: ignore[misc]  # numba is untyped
    """Reads callees back."""

    def rebuild(self, target_context: Any, payload: Any) -> CompileResult:
        """Return the compiled callee that was saved."""
        (name, bitcode), fndesc, environment, signature, *rest, reload_init, envs = payload
        for load in reload_init:
            load()
        objectmode, lifted, annotation = rest
        return CompileResult(
            typing_context=target_context.typing_context,
            target_context=target_context,
            entry_point=object(),
            typing_error=None,
            type_annotation=annotation,
            signature=signature,
            objectmode=objectmode,
            lifted=lifted,
            fndesc=fndesc,
            library=_CalleeLibrary.of(target_context.codegen(), name, bitcode, reload_init),
            call_helper=None,
            environment=environment,
            metadata=None,
            reload_init=reload_init,
            referenced_envs=envs,
        )


class _Callee(CPUDispatcher):  # type: ignore[misc]  # numba is untyped
    """A kernel as other kernels call it. Its entry points are but names by which callers find the code.

    It is compiled anew where Python has called the kernel: that one's machine code could be called, not taken in.
    """

    def __init__(self, kernel: "Kernel") -> None:
        options = {**kernel.targetoptions, "no_cpython_wrapper": True}
        super().__init__(kernel.py_func, {}, options, _CalleeCompiler)

    def add_overload(self, cres: CompileResult) -> None:
        """Let callers find a callee."""
        if cres.entry_point is None:
            cres = cres._replace(entry_point=object())
            self.targetctx.insert_user_function(cres.entry_point, cres.fndesc, [cres.library])
        self.overloads[tuple(cres.signature.args)] = cres


class Kernel(CPUDispatcher):  # type: ignore[misc]  # numba is untyped
    """A kernel as Python calls it; kernels that call it are given its callee."""

    def __init__(self, function: Callable[..., Any], options: dict[str, Any]) -> None:
        """Take a function and numba's options. `caches`, set later, make what keeps the kernel and its callee."""
        super().__init__(function, {}, options, _KernelCompiler)
        self.caches: tuple[Callable[[], Any], Callable[[], Any]] | None = None
        self._callee: _Callee | None = None
        self._opened = False

    def compile(self, sig: Any) -> Any:
        """Compile for these types."""
        self._open_cache()
        return super().compile(sig)

    def _open_cache(self) -> None:
        """Find where the kernel is kept: only as it is needed, for most kernels never are."""
        if not self._opened and self.caches is not None:
            self._cache = self.caches[0]()
        self._opened = True

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """Return how a kernel calls this one: constants as any value of their type, so that one compilation serves."""
        if self._callee is None:
            self._callee = _Callee(self)
            if self.caches is not None:
                self._callee._cache = self.caches[1]()
        plain = tuple(map(types.unliteral, args))
        return self._callee.get_call_template(
            plain, {n: types.unliteral(t) for n, t in kws.items()}
        )

    def get_overload(self, sig: Any) -> Any:
        """Return the name of the callee for a caller's call."""
        return self._callee.get_overload(sig) if self._callee else super().get_overload(sig)

    def add_overload(self, cres: CompileResult) -> None:
        """Take a compiled kernel in, and tell its code where the constants of its callees lie."""
        super().add_overload(cres)
        for environment in cres._find_referenced_environments():
            cres.codegen.set_env(environment.env_name, environment)


def entry(kernel: Kernel, args: tuple[Any, ...]) -> tuple[Callable[..., Any], int]:
    """Return the machine code of the kernel for the types of `args`, and for how many words of memory it asks.

    It must be given arguments of no other types.
    """
    signature = tuple(map(kernel.typeof_pyval, args))
    kernel.compile(signature)
    code: Callable[..., Any] = kernel.overloads[signature].entry_point
    return code, words_of(kernel.targetctx, signature)
