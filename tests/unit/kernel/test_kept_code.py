"""Compiled loops on disk: reused while nothing changed, rebuilt after any change of the kernel, dispensable."""

from __future__ import annotations

import importlib.util
from types import ModuleType

import pytest

from jounce.kernel import call, native

SOURCE = """
from jounce.kernel.call import kept


@kept()
def double(x):
    return 2.0 * x
"""


def fresh(file) -> ModuleType:
    spec = importlib.util.spec_from_file_location("kept_code", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert module.double(1.5) == 3.0
    return module


def test_code_is_reused_until_a_source_of_the_kernel_changes(tmp_path, monkeypatch):
    file = tmp_path / "kept_code.py"
    file.write_text(SOURCE)
    assert sum(fresh(file).double.stats.cache_misses.values()) == 1
    assert sum(fresh(file).double.stats.cache_hits.values()) == 1
    monkeypatch.setattr(call, "digest_of", lambda *_: "another kernel")
    assert sum(fresh(file).double.stats.cache_misses.values()) == 1


def test_without_a_folder_to_write_to_the_function_is_compiled_all_the_same(tmp_path, monkeypatch):
    file = tmp_path / "kept_code.py"
    file.write_text(SOURCE)
    real = call.njit

    def nowhere(*, cache: bool = False, **options):
        if cache:
            raise RuntimeError("cannot cache function: no locator available")
        return real(**options)

    monkeypatch.setattr(call, "njit", nowhere)
    fresh(file)


def test_without_a_home_folder_models_are_compiled_all_the_same(monkeypatch):
    def homeless() -> None:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("JOUNCE_CACHE_DIR", raising=False)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(native.Path, "home", homeless)
    with pytest.raises(RuntimeError):
        native.cache_folder()
    assert native._read("key") is None
    native._write("key", b"code")


def test_native_code_is_not_taken_from_another_kernel(monkeypatch, tmp_path):
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path))
    made = []

    def make() -> native.Source:
        made.append(1)
        return native.Source({})

    for digest in ("one kernel", "one kernel", "another kernel"):
        monkeypatch.setattr(native, "digest_of", lambda *_, digest=digest: digest)
        native.kept_code("nothing", make)
    assert len(made) == 2
