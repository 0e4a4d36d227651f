"""Numbers with as many digits as their uncertainty justifies."""

from __future__ import annotations

import math

# The uncertainty is written with two digits (GUM 7.2.6: at most two).
DIGITS_OF_U = 2
# A number stated without uncertainty.
DIGITS_WITHOUT_U = 6


def decimals_for(u: float) -> int:
    """Decimal places that show two digits of ``u`` after rounding."""
    if not math.isfinite(u) or u <= 0.0:
        return 0
    # The exponent after rounding: 0.0996 becomes 0.10.
    exponent = int(f"{u:.{DIGITS_OF_U - 1}e}".partition("e")[2])
    return max(0, DIGITS_OF_U - 1 - exponent)


def with_u(value: float | None, u: float | None, unit: str = "") -> str:
    """``1.05660 ± 0.00090 m``; a dash where there is no value."""
    if value is None:
        return "–"
    tail = f" {unit}" if unit else ""
    if u is None or not math.isfinite(u) or u <= 0.0:
        return f"{value:.{DIGITS_WITHOUT_U}g}{tail}"
    places = decimals_for(u)
    return f"{value:.{places}f} ± {u:.{places}f}{tail}"


def interval(bounds: tuple[float, float] | None, u: float) -> str:
    """``1.0548 … 1.0584``, with the digits of the uncertainty."""
    if bounds is None:
        return ""
    places = decimals_for(u)
    return f"{bounds[0]:.{places}f} … {bounds[1]:.{places}f}"


def short(value: float | None, digits: int = 3) -> str:
    """A number of which only the size matters."""
    return "–" if value is None else f"{value:.{digits}g}"
