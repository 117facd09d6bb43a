"""Rigs load from the cache without their equations; whatever they depend on makes another entry."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce import models
from jounce.core.remembered import Recent
from jounce.kernel import native
from jounce.models import build
from jounce.simulation import compiled as compiled_module
from jounce.simulation.compiled import compile_model, compile_rig

KART = jn.load("kart-quarter-car")
FREE = ("tyre.stiffness", "sprung.mass")
TRIAL = jn.Trial(
    road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.2 s"
)


@pytest.fixture
def fresh(tmp_path, monkeypatch):
    """A process that has compiled nothing, with an empty cache; calling it forgets again. Counts builds and code."""
    jn.simulate(KART, TRIAL)  # the code of its loops is loaded: it would be kept in that cache, too
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(compiled_module, "_compiled", Recent())
    counts = {"built": 0, "emitted": 0}

    def counted(name, function):
        def call(*arguments, **options):
            counts[name] += 1
            return function(*arguments, **options)

        return call

    monkeypatch.setattr(models, "build", counted("built", models.build))
    monkeypatch.setattr(native, "_emit", counted("emitted", native._emit))

    def forget():
        compiled_module._compiled.clear()
        return counts

    return forget


def test_second_process_builds_no_equations(fresh):
    counts = fresh()
    first = compile_rig(KART, FREE)
    assert counts == {"built": 2, "emitted": 2}, "with and without sensitivities"
    fresh()
    second = compile_rig(KART.with_changes({"sprung.mass": 20.0}), FREE)
    assert counts == {"built": 2, "emitted": 2}
    assert second is not first
    assert second.facts == first.facts
    assert (second.shapes, second.scalars, second.lanes) == (
        first.shapes,
        first.scalars,
        first.lanes,
    )
    assert second.plain.facts == first.plain.facts


def test_what_comes_from_the_cache_computes_the_same(fresh):
    fresh()
    first = jn.sensitivities(KART, TRIAL, FREE)
    fresh()
    second = jn.sensitivities(KART, TRIAL, FREE)
    assert first.identical(second)


def test_equations_are_there_when_asked_for(fresh):
    counts = fresh()
    compile_rig(KART)
    fresh()
    compiled = compile_rig(KART)
    assert counts["built"] == 1
    assert compiled.model is build(KART)
    assert compiled.functions["rate"].n_instructions() > 0


@pytest.mark.parametrize(
    ("change", "free"),
    [
        ({"tyre.lift_off": False}, ()),
        ({}, FREE),
        ({}, FREE[::-1]),
        ({"strut.friction": {"force": 1.0}}, ()),
    ],
)
def test_another_structure_or_choice_is_another_entry(fresh, change, free):
    counts = fresh()
    compile_rig(KART)
    before = counts["emitted"]
    compile_rig(KART.with_changes(change), free)
    assert counts["emitted"] > before


def test_other_sources_are_another_entry(fresh, monkeypatch):
    counts = fresh()
    compile_rig(KART)
    fresh()
    monkeypatch.setattr(compiled_module, "sources", lambda: "another version")
    compile_rig(KART)
    assert counts == {"built": 2, "emitted": 2}


def test_detail_is_another_entry(fresh):
    counts = fresh()
    rig = jn.load("kart-double-wishbone")
    plain, detailed = compile_rig(rig), compile_rig(rig, detail=True)
    assert counts["emitted"] == 2
    assert len(detailed.output_names) > len(plain.output_names)


def test_damaged_entry_is_rebuilt(fresh, tmp_path):
    counts = fresh()
    expected = jn.simulate(KART, TRIAL)
    (entry,) = tmp_path.iterdir()
    for times, at in enumerate((0, 36, 44, 300, -5), 1):
        content = bytearray(entry.read_bytes())
        content[at] ^= 1
        entry.write_bytes(bytes(content))
        fresh()
        assert jn.simulate(KART, TRIAL).identical(expected), at
        assert counts["emitted"] == 1 + times, at


def test_entry_of_another_rig_is_rebuilt(fresh, tmp_path):
    counts = fresh()
    compile_rig(KART.with_changes({"tyre.lift_off": False}))
    (other,) = tmp_path.iterdir()
    stale = other.read_bytes()
    compile_rig(KART)
    (entry,) = (file for file in tmp_path.iterdir() if file != other)
    entry.write_bytes(stale)
    fresh()
    assert "tyre contact" in compile_rig(KART).facts.switches
    assert counts["emitted"] == 3


def test_slopes_are_those_of_the_functions():
    """Central differences of rates and outputs along states, inputs and free parameters."""
    rig = KART.with_changes({"tyre.damping_coefficient": 50.0})
    model = build(rig)
    free = model.parameters[::-1]
    compiled = compile_model(model, free)
    p = compiled.parameter_values(rig.parameters())
    generator = np.random.default_rng(0)
    x, u = 1e-3 * generator.normal(size=4), 1e-3 * generator.normal(size=2)
    at, m = {"x": x, "u": u, "p": p}, np.ones(1)
    rate, loops = compiled.free_slopes(x, u, p, m)
    assert loops.shape == (0, len(free))
    for by in "xup":
        found = {"rate": rate[:, ::-1]} if by == "p" else compiled.slopes(by, x, u, p, m)
        for i in range(len(at[by])):
            step = 1e-4 * max(abs(at[by][i]), 1e-3)
            for part in ("rate", "output")[: 1 if by == "p" else 2]:
                ends = []
                for sign in (1, -1):
                    moved = {**at, by: at[by] + sign * step * np.eye(len(at[by]))[i]}
                    ends.append(compiled.evaluate(part, moved["x"], moved["u"], moved["p"], m))
                expected = (ends[0] - ends[1]) / (2 * step)
                size = max(float(np.max(np.abs(expected))), 1e-6)
                assert np.max(np.abs(found[part][:, i] - expected)) < 1e-6 * size, (by, i, part)
