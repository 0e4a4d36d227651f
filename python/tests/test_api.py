"""The Python API on sessions, measurements and arrays."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from conftest import seed, swing_csv

import gyradius


def test_every_public_name_is_there() -> None:
    assert [name for name in gyradius.__all__ if not hasattr(gyradius, name)] == []


def test_shipped_sessions_are_found() -> None:
    assert {"boat-park", "keelboat", "model-hull"} <= set(gyradius.shipped_sessions())


def test_unknown_shipped_session_names_the_known() -> None:
    with pytest.raises(gyradius.InputError, match="keelboat"):
        gyradius.shipped_session("submarine")


def test_views_hold_what_the_json_holds(keelboat: gyradius.Measurement) -> None:
    data = json.loads(keelboat.to_json())
    assert keelboat.format == data["format"] == "gyradius-measurement/1"
    assert [swing.id for swing in keelboat.swings] == [swing["id"] for swing in data["swings"]]
    for name, quantity in keelboat.quantities.items():
        assert np.allclose(quantity.value, data["quantities"][name]["value"], rtol=0, atol=0)
    assert len(keelboat.consistency) == len(data["consistency"])
    assert sum(map(len, keelboat.alternatives.values())) == sum(map(len, data["alternatives"].values()))


def test_limits_get_verdicts(keelboat: gyradius.Measurement) -> None:
    verdict = keelboat.verdicts[0]
    assert (verdict.quantity, verdict.relation, verdict.limit) == ("k_yaw_m", ">=", 1.0)
    assert verdict.verdict in {"pass", "fail", "undecided"}
    assert 0.0 <= verdict.conformance_probability <= 1.0


@pytest.mark.parametrize("limit", ["k_yaw_m", "k_yaw_m=1", "k_yaw_m>=tall", ">=1", ""])
def test_limits_that_are_none_are_refused(limit: str) -> None:
    session = gyradius.load(gyradius.shipped_session("keelboat"))
    with pytest.raises(gyradius.InputError):
        session.measure(limits=[limit])


def test_errors_carry_file_and_line(folder: Callable[..., Path]) -> None:
    path = folder('format = "gyradius-session/1"\ntitle = "x"\nlenght = 1\n')
    with pytest.raises(gyradius.InputError, match="lenght") as caught:
        gyradius.load(path)
    assert caught.value.file is not None
    assert caught.value.file.endswith("session.toml")
    assert caught.value.line == 3
    assert isinstance(caught.value, gyradius.GyradiusError)
    assert isinstance(caught.value, ValueError)


def test_bare_recording_gives_modes_alone(tmp_path: Path) -> None:
    path = tmp_path / "yaw.csv"
    path.write_text(swing_csv(period_s=2.0))
    measurement = gyradius.load(path).measure()
    mode = measurement.swings[0].modes[0]
    assert abs(mode.period_s - 2.0) < 5 * mode.period_se_s + 1e-4
    assert measurement.quantities == {}


def test_decompose_finds_the_period_that_was_put_in() -> None:
    t_s = np.arange(0.0, 60.0, 0.02)
    rng = np.random.default_rng(seed())
    # exp(-αt) cos(ωt) with ω = 2π/2.5 s and α = 1/200 s, and noise of 0.002.
    signal = 0.2 * np.exp(-t_s / 200.0) * np.cos(2 * np.pi * t_s / 2.5)
    found = gyradius.decompose(t_s, [signal + rng.normal(0, 0.002, t_s.size), rng.normal(0, 0.002, t_s.size)])
    assert len(found.modes) == 1
    mode = found.modes[0]
    # 5 standard errors: a right program misses once in 1.7 million runs.
    assert abs(mode.period_s - 2.5) < 5 * mode.period_se_s
    assert mode.shape.shape == (2,)
    fit = found.evaluate(t_s)
    assert fit.shape == (2, t_s.size)
    assert np.std(fit[0] - signal) < 0.002


def test_decompose_refuses_what_is_no_record() -> None:
    with pytest.raises(gyradius.GyradiusError):
        gyradius.decompose([0.0, 1.0], [[1.0, 2.0]])
    with pytest.raises(gyradius.GyradiusError):
        gyradius.decompose(np.arange(100.0), [np.zeros(99)])
    with pytest.raises(gyradius.GyradiusError):
        gyradius.decompose(np.arange(100.0), [])
    with pytest.raises(gyradius.GyradiusError):
        gyradius.decompose(np.full(100, np.nan), [np.zeros(100)])


def test_arrays_that_are_not_contiguous_are_read_right() -> None:
    t_s = np.arange(0.0, 60.0, 0.02)
    both = np.stack([np.cos(2 * np.pi * t_s / 2.5), np.sin(2 * np.pi * t_s / 2.5)], axis=1)
    both += np.random.default_rng(seed()).normal(0, 1e-3, both.shape)
    found = gyradius.decompose(t_s, [both[:, 0], both[:, 1]])
    assert abs(found.modes[0].period_s - 2.5) < 5 * found.modes[0].period_se_s


def test_other_threads_run_while_the_core_works() -> None:
    session = gyradius.load(gyradius.shipped_session("boat-park"))
    worker = threading.Thread(target=session.measure)
    begun = time.monotonic()
    worker.start()
    longest, last = 0.0, time.monotonic()
    while worker.is_alive():
        time.sleep(0.001)
        now = time.monotonic()
        longest, last = max(longest, now - last), now
    # With the lock held, the one pause would be the whole measurement.
    assert longest < 0.5 * (time.monotonic() - begun) + 0.05


def test_plot_draws_every_recording() -> None:
    measurement = gyradius.load(gyradius.shipped_session("boat-park")).measure()
    figure = measurement.plot()
    assert len(figure.subfigs) == len(measurement.recorded_swings) > 0
    for swing_id in measurement.recorded_swings:
        for labels, t_s, samples, fit in measurement.fits(swing_id):
            assert samples.shape == fit.shape == (len(labels), t_s.size)


def test_plot_of_typed_periods_says_why_there_is_none(keelboat: gyradius.Measurement) -> None:
    with pytest.raises(gyradius.NoResultError, match="typed"):
        keelboat.plot()


def test_report_in_german(keelboat: gyradius.Measurement) -> None:
    html = keelboat.to_html("kein Grund", language="de")
    assert '<html lang="de">' in html
    assert "Trägheitsradius Gieren" in html
    assert "kein Grund." in html
    assert '<html lang="en">' in keelboat.to_html()
    with pytest.raises(gyradius.InputError, match="language"):
        keelboat.to_html(language="fr")


def test_report_is_one_file_without_links(keelboat: gyradius.Measurement) -> None:
    html = keelboat.to_html()
    assert html.lstrip().lower().startswith("<!doctype html>")
    assert "<svg" in html
    for outside in ('src="http', 'href="http', "url(http", "@import"):
        assert outside not in html
