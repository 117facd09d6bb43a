"""Native code is kept where that is possible, and taken for no other kernel's."""

from __future__ import annotations

import pytest

from jounce.kernel import native


def test_without_a_home_folder_models_are_compiled_all_the_same(monkeypatch):
    def homeless() -> None:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("JOUNCE_CACHE_DIR", raising=False)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(native.Path, "home", homeless)
    with pytest.raises(RuntimeError):
        native.cache_folder()
    assert native.recall("key") is None
    native.keep("key", b"code")


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
