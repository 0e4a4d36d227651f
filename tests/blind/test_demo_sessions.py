"""The sessions that ship are what their generator writes, and the simulated one comes out true."""

import json

import coverage
import make_demo_sessions as demo
import numpy as np
import pytest

LAST_DECIMAL = 1.01 * np.array([1e-5, 1e-5, 1e-5, 1e-5, 1e-3, 1e-3, 1e-3])


def test_shipped_sessions_are_what_the_script_writes(tmp_path, monkeypatch):
    """Texts to the letter; recordings to their last decimal, which another processor may round otherwise."""
    shipped = demo.SESSIONS
    monkeypatch.setattr(demo, "SESSIONS", tmp_path)
    monkeypatch.setattr(demo, "HERE", tmp_path)
    demo.main()
    for path in sorted(p for p in shipped.rglob("*") if p.is_file()):
        again = tmp_path / path.relative_to(shipped)
        if path.suffix != ".csv":
            assert path.read_text() == again.read_text(), path.name
            continue
        ours, theirs = (np.genfromtxt(p, delimiter=",", skip_header=1) for p in (path, again))
        assert np.all(np.nanmax(np.abs(ours - theirs), axis=0) < LAST_DECIMAL), path.name


def test_the_package_data_stay_small():
    """Under 3 MB, so that the wheel stays one that people install without thinking."""
    assert sum(p.stat().st_size for p in demo.SESSIONS.rglob("*") if p.is_file()) < 3e6


def test_boat_park_comes_out_true():
    """Each quantity within 3.5 standard uncertainties (once in 430 for five honest ones; the data are fixed), no wrong name."""
    pytest.importorskip("gyradius", reason="the package is not installed")
    truth = json.loads((demo.HERE / "boat-park.truth.json").read_text())
    outcome = coverage.judge_session("boat-park", truth, *coverage.measure(demo.SESSIONS / "boat-park"))
    assert not outcome.trouble
    assert not outcome.absent + outcome.wrong_names + outcome.missed_modes
    assert {q: z for q, z in outcome.z.items() if abs(z) > 3.5} == {}
