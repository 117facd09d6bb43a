"""Digests of sources tell every edit."""

from __future__ import annotations

from jounce.core import sources


def test_an_edit_is_noticed(tmp_path, monkeypatch) -> None:
    module = tmp_path / "made_up" / "part" / "one.py"
    module.parent.mkdir(parents=True)
    module.write_text("a = 1\n")
    monkeypatch.setattr(sources, "__file__", str(tmp_path / "core" / "sources.py"))
    sources.digest_of("made_up")
    assert not sources.edited_since("made_up")
    module.write_text("a = 2\n")
    assert sources.edited_since("made_up")
    module.write_text("a = 1\n")
    assert not sources.edited_since("made_up")
    (module.parent / "two.py").write_text("")
    assert sources.edited_since("made_up")
