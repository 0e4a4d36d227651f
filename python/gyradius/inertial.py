"""The hull as a rigid body for simulators: ``<inertial>`` of URDF, MuJoCo (MJCF) and SDFormat.

# Conventions
All three hold the inertia about the centre of mass, along the axes of the body's frame, by the elements of its
matrix: ``ixz`` is I_xz = −Σ m x z, as the core has it. No sign is turned. MuJoCo's ``fullinertia`` has the order xx,
yy, zz, xy, xz, yz. The body's frame is the hull axes: x forward, y to port, z up, from the mid-point of the suspension
points.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from xml.etree.ElementTree import Comment, Element, SubElement, indent, tostring

import numpy as np

from ._core import NoResultError
from .console import UNSEEN
from .measurement import Measurement, Quantity
from .numbers import with_u

BODY = "hull"
SDF_VERSION = "1.7"
GYRADII = ("k_roll_m", "k_pitch_m", "k_yaw_m")
# Far below any uncertainty; the swings do not tell more.
DIGITS = 9
# Moments of a flat body that miss the triangle inequality by rounding alone.
SLACK = 1e-9
# Masses by three axes that differ by no more than this are one, rounded.
SAME_MASS = 1e-6
# Elements of the matrix by their names, in the order of URDF and SDFormat.
PLACES = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
FULL_INERTIA = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")


@dataclass(frozen=True, slots=True)
class RigidBody:
    """The hull alone: mass, centre of mass and inertia about it, in hull axes."""

    title: str
    mass_kg: float
    inertia: Quantity
    #: By how much the mass differs between the three axes, relative; only where the core averaged over solutions.
    mass_spread: float
    #: Of the centre of mass below the suspension points; None where the swings do not determine it.
    depth: Quantity | None
    warnings: int

    @property
    def centre_m(self) -> str:
        """The centre of mass in the body's frame, as attributes have it."""
        return f"0 0 {_figure(-self.depth.value if self.depth else 0.0)}"

    @property
    def moments(self) -> dict[str, str]:
        """Elements of the matrix by their names."""
        return {name: _figure(self.inertia.value[i][j]) for name, (i, j) in PLACES.items()}


def rigid_body(measurement: Measurement) -> RigidBody:
    """The hull of a measurement; ``NoResultError`` where its inertia or mass is not determined."""
    found = measurement.quantities
    inertia = found.get("inertia_kg_m2")
    if inertia is None:
        raise NoResultError(_missing(measurement))
    _check(inertia)
    # By the definition of a gyradius, I = m k². Where the core averages over solutions, the mean of k² exceeds the
    # square of the mean of k; the least of the three is the nearest.
    masses_kg = [float(inertia.value[i][i]) / found[name].value ** 2 for i, name in enumerate(GYRADII)]
    spread = max(masses_kg) / min(masses_kg) - 1.0
    depth = found.get("cm_depth_m")
    return RigidBody(measurement.title, min(masses_kg), inertia, spread, depth, len(measurement.warnings))


def _missing(measurement: Measurement) -> str:
    missing = [name for name in GYRADII if name not in measurement.quantities]
    lead = f"{measurement.title}: no <inertial> can be written: "
    if missing:
        return f"{lead}the swings do not determine {', '.join(missing)}; `gyradius plan` says which swings would"
    return f"{lead}without the mass there are gyradii but no moments of inertia; state `mass` in [body]"


def _check(inertia: Quantity) -> None:
    """Refuse what simulators refuse: no body has such moments."""
    moments = np.linalg.eigvalsh(np.array(inertia.value))
    if moments[0] <= 0.0 or moments[2] > (moments[0] + moments[1]) * (1.0 + SLACK):
        listed = ", ".join(f"{moment:.5g}" for moment in moments)
        raise NoResultError(
            f"no <inertial> can be written: no body has the principal moments {listed} kg m², as one exceeds the sum"
            " of the others or is not positive; check the stated dimensions and attachments, or swing again"
        )


def urdf(measurement: Measurement, *, model: bool = False) -> str:
    """The hull as ``<inertial>`` of URDF, or as a robot of one link."""
    body = rigid_body(measurement)
    inertial = _commented(body)
    SubElement(inertial, "origin", xyz=body.centre_m, rpy="0 0 0")
    SubElement(inertial, "mass", value=_figure(body.mass_kg))
    SubElement(inertial, "inertia", body.moments)
    root = Element("robot", name=BODY)
    SubElement(root, "link", name=BODY).append(inertial)
    return _text(root if model else inertial)


def mjcf(measurement: Measurement, *, model: bool = False) -> str:
    """The hull as ``<inertial>`` of MuJoCo, or as a model of one free body."""
    body = rigid_body(measurement)
    inertial = _commented(body)
    inertial.set("pos", body.centre_m)
    inertial.set("mass", _figure(body.mass_kg))
    inertial.set("fullinertia", " ".join(body.moments[name] for name in FULL_INERTIA))
    root = Element("mujoco", model=BODY)
    hull = SubElement(SubElement(root, "worldbody"), "body", name=BODY)
    SubElement(hull, "freejoint")
    hull.append(inertial)
    return _text(root if model else inertial)


def sdf(measurement: Measurement, *, model: bool = False) -> str:
    """The hull as ``<inertial>`` of SDFormat, or as a model of one link."""
    body = rigid_body(measurement)
    inertial = _commented(body)
    SubElement(inertial, "pose").text = f"{body.centre_m} 0 0 0"
    SubElement(inertial, "mass").text = _figure(body.mass_kg)
    moments = SubElement(inertial, "inertia")
    for name, moment in body.moments.items():
        SubElement(moments, name).text = moment
    root = Element("sdf", version=SDF_VERSION)
    SubElement(SubElement(root, "model", name=BODY), "link", name=BODY).append(inertial)
    return _text(root if model else inertial)


def _figure(value: float) -> str:
    # Adding zero turns -0 into 0.
    return f"{value + 0.0:.{DIGITS}g}"


def _text(root: Element) -> str:
    indent(root)
    return tostring(root, encoding="unicode") + "\n"


def _commented(body: RigidBody) -> Element:
    """An ``<inertial>`` that says what its figures are."""
    inertial = Element("inertial")
    lines = [body.title, "The hull alone, from swings (gyradius). SI units; +/- is one standard uncertainty."]
    lines += [*_about_frame(body), *_about_inertia(body.inertia)]
    if body.warnings:
        lines.append(f"The measurement has {body.warnings} warning(s), which `gyradius measure` shows.")
    inertial.append(Comment("\n" + "".join(f"  {_harmless(line)}\n" for line in lines)))
    return inertial


def _about_frame(body: RigidBody) -> list[str]:
    axes = "Axes: x forward, y to port, z up, fixed to the hull as it hung level."
    mass = "Mass: as the session states it, less its attachments."
    if body.mass_spread > SAME_MASS:
        mass += f" Known to {100.0 * body.mass_spread:.2g} % only: the session contradicts itself."
    if body.depth is None:
        origin = "Origin: the centre of mass. Its depth below the suspension points is UNKNOWN: no swing determines it."
        return [axes, origin, mass]
    depth = with_u(body.depth.value, body.depth.u, "m")
    return [
        axes,
        "Origin: the mid-point of the suspension points.",
        f"Centre of mass: {depth} below the origin; x = y = 0 is that of all that hung.",
        "Attachments that were taken off shift the hull's own centre by -sum(m x) / mass, and y alike. That shift is",
        "UNKNOWN here and left out; without attachments it is 0.",
        mass,
    ]


def _about_inertia(inertia: Quantity) -> list[str]:
    moments = [with_u(inertia.value[i][i], inertia.u[i][i]) for i in range(3)]
    lines = [
        "Inertia: about the centre of mass, along the axes; elements of the matrix, ixz = -sum(m x z).",
        f"ixx = {moments[0]}, iyy = {moments[1]}, izz = {moments[2]} kg m^2",
    ]
    if inertia.u[0][2] > 0.0:
        lines.append(f"ixz = {with_u(inertia.value[0][2], inertia.u[0][2])} kg m^2")
    else:
        lines.append("ixz is UNKNOWN (no tilted swing determines it) and set to 0.")
    return [*lines, "ixy and iyz are 0: port and starboard are taken to be alike."]


def _harmless(text: str) -> str:
    """A text that may stand in a comment of XML and in any encoding of it."""
    one_line = UNSEEN.sub("?", text.replace("±", "+/-").replace("\n", " "))
    return re.sub("-(?=-|$)", "- ", one_line)
