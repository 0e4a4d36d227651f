"""Digits follow the uncertainty."""

from __future__ import annotations

import pytest

from gyradius.numbers import decimals_for, interval, with_u


@pytest.mark.parametrize(
    ("value", "u", "text"),
    [
        (1.05663, 0.00091, "1.05663 ± 0.00091"),
        (1.05663, 0.0123, "1.057 ± 0.012"),
        (4.3912, 2e-5, "4.391200 ± 0.000020"),
        # 0.0996 rounds to two digits as 0.10, not as 0.100.
        (1.0, 0.0996, "1.00 ± 0.10"),
        (622.7, 0.5, "622.70 ± 0.50"),
        (1234.5, 12.3, "1234 ± 12"),
        (1234.5, 345.0, "1234 ± 345"),
        (9.80665, 0.0, "9.80665"),
        # The largest number that there is, which cannot be rounded up.
        (1.0, 1.79e308, f"1 ± {1.79e308:.0f}"),
    ],
)
def test_value_with_uncertainty(value: float, u: float, text: str) -> None:
    assert with_u(value, u) == text


def test_absent_value_is_a_dash() -> None:
    assert with_u(None, None) == "–"


def test_interval_has_the_digits_of_u() -> None:
    assert interval((1.05484, 1.05842), 0.00091) == "1.05484 … 1.05842"
    assert interval(None, 0.1) == ""


@pytest.mark.parametrize("u", [float("nan"), float("inf"), -1.0, 0.0])
def test_uncertainty_that_is_none_asks_for_no_decimals(u: float) -> None:
    assert decimals_for(u) == 0
