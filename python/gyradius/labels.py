"""Names and units of quantities, for people."""

from __future__ import annotations

LABELS = {
    "k_yaw_m": "Yaw gyradius",
    "k_pitch_m": "Pitch gyradius",
    "k_roll_m": "Roll gyradius",
    "cm_depth_m": "Depth of centre of mass",
    "psi_deg": "Tilt ψ of principal axes",
    "inertia_yaw_kg_m2": "Yaw moment of inertia",
    "inertia_pitch_kg_m2": "Pitch moment of inertia",
    "inertia_roll_kg_m2": "Roll moment of inertia",
    "principal_gyradii_m": "Principal gyradius",
    "inertia_kg_m2": "Inertia",
}
UNITS = {
    "k_yaw_m": "m",
    "k_pitch_m": "m",
    "k_roll_m": "m",
    "cm_depth_m": "m",
    "psi_deg": "°",
    "principal_gyradii_m": "m",
    "inertia_kg_m2": "kg m²",
    "inertia_yaw_kg_m2": "kg m²",
    "inertia_pitch_kg_m2": "kg m²",
    "inertia_roll_kg_m2": "kg m²",
}


def label(name: str) -> str:
    """``Yaw gyradius`` for ``k_yaw_m``; other keys of the format as words."""
    return LABELS.get(name) or name.replace("_", " ")
