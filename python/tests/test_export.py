"""Data out of a measurement: dictionaries, tables, workbooks, and the hull as a rigid body for simulators."""

from __future__ import annotations

import csv
import json
import re
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import assert_refused, parsed, run, swing_csv

import gyradius
from gyradius.datatables import TABLES
from gyradius.export import Table

openpyxl = pytest.importorskip("openpyxl")
pd = pytest.importorskip("pandas")

# Point masses, kg, by their place in hull axes, m: heavy and high at the bow, so that the principal x axis is bow up.
POINTS = {
    (1.2, 0.0, 0.10): 3.0,
    (-0.9, 0.0, -0.45): 4.0,
    (0.1, 0.5, -0.3): 2.0,
    (0.1, -0.5, -0.3): 2.0,
}
PLACES = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}


@pytest.fixture(scope="module")
def model_hull() -> gyradius.Measurement:
    """The paper's model, of which the swings determine everything."""
    return gyradius.load(gyradius.shipped_session("model-hull")).measure()


def points() -> tuple[float, np.ndarray, np.ndarray]:
    """Mass, centre and inertia about it of the point masses, by the definition: sum of m (r² 1 − r rᵀ)."""
    masses, places = np.array(list(POINTS.values())), np.array(list(POINTS))
    centre = masses @ places / masses.sum()
    offsets = places - centre
    inertia = sum(m * (r @ r * np.eye(3) - np.outer(r, r)) for m, r in zip(masses, offsets, strict=True))
    return float(masses.sum()), centre, np.asarray(inertia)


def made_of_points(measurement: gyradius.Measurement) -> gyradius.Measurement:
    """A measurement that found the point masses; x of their centre is 0 only where the origin is put above it."""
    mass, centre, inertia = points()
    k = np.sqrt(np.diag(inertia) / mass)
    one = {"u": 1e-3, "method": "joint_estimate"}
    quantities = {
        "inertia_kg_m2": gyradius.Quantity(tuple(map(tuple, inertia.tolist())), ((1e-3,) * 3,) * 3, "joint_estimate"),
        **{f"k_{name}_m": gyradius.Quantity(k[i], **one) for i, name in enumerate(("roll", "pitch", "yaw"))},
        "cm_depth_m": gyradius.Quantity(-centre[2], **one),
    }
    return replace(measurement, quantities=quantities)


# Tables.


def test_to_dict_is_the_json(keelboat: gyradius.Measurement) -> None:
    assert keelboat.to_dict() == json.loads(keelboat.to_json())


def test_quantities_are_a_tidy_table(model_hull: gyradius.Measurement) -> None:
    table, data = model_hull.to_frame(), model_hull.to_dict()["quantities"]
    assert list(table.columns) == ["name", "element", "value", "u", "low_95", "high_95", "unit", "method"]
    assert set(table["name"]) == set(data)
    scalars = table[table["element"] == ""].set_index("name")
    assert scalars.loc["k_yaw_m", "value"] == data["k_yaw_m"]["value"]
    assert list(scalars.loc["k_yaw_m", ["low_95", "high_95"]]) == data["k_yaw_m"]["interval_95"]
    assert dict(scalars["unit"]) == {name: "deg" if name == "psi_deg" else "m" for name in scalars.index}
    inertia = table[table["name"] == "inertia_kg_m2"].set_index("element")
    assert inertia.loc["xz", "value"] == data["inertia_kg_m2"]["value"][0][2]
    assert inertia.loc["xz", "u"] == data["inertia_kg_m2"]["u"][0][2]
    assert set(inertia["unit"]) == {"kg m^2"}


def test_modes_have_a_row_for_each_mode_of_each_swing(model_hull: gyradius.Measurement) -> None:
    table = model_hull.to_frame("modes")
    expected = [
        (swing["id"], mode["mode"], mode["period_s"], mode["period_se_s"])
        for swing in model_hull.to_dict()["swings"]
        for mode in swing["modes"]
    ]
    assert list(table[["swing", "mode", "period_s", "period_se_s"]].itertuples(index=False, name=None)) == expected


@pytest.mark.parametrize("name", TABLES)
def test_every_table_has_the_rows_of_the_json(model_hull: gyradius.Measurement, name: str) -> None:
    data = model_hull.to_dict()
    counts = {
        "modes": sum(len(swing["modes"]) for swing in data["swings"]),
        "budget": sum(map(len, data["budget"].values())),
        "consistency": len(data["consistency"]),
        "findings": len(data["findings"]),
    }
    assert len(model_hull.to_frame(name)) == counts.get(name, len(model_hull.to_frame()))


def test_tables_of_nothing_keep_their_columns(tmp_path: Path) -> None:
    recording = tmp_path / "yaw.csv"
    recording.write_text(swing_csv())
    measurement = gyradius.load(recording).measure()
    assert measurement.to_frame().empty
    assert "value" in measurement.to_frame().columns
    measurement.to_xlsx(tmp_path / "yaw.xlsx")
    assert len(measurement.to_frame("modes")) >= 1


def test_a_csv_reads_back_to_the_last_digit(model_hull: gyradius.Measurement, tmp_path: Path) -> None:
    target = tmp_path / "quantities.csv"
    model_hull.to_csv(target)
    rows = list(csv.DictReader(target.read_text(encoding="ascii").splitlines()))
    values = {(row["name"], row["element"]): float(row["value"]) for row in rows}
    assert values["k_pitch_m", ""] == model_hull.quantities["k_pitch_m"].value
    assert values["inertia_kg_m2", "zz"] == model_hull.quantities["inertia_kg_m2"].value[2][2]
    assert [row["low_95"] for row in rows if row["element"]] == [""] * sum(bool(row["element"]) for row in rows)


def test_a_workbook_has_all_tables(model_hull: gyradius.Measurement, tmp_path: Path) -> None:
    target = tmp_path / "hull.xlsx"
    model_hull.to_xlsx(target)
    sheets = pd.read_excel(target, sheet_name=None, keep_default_na=False)
    assert list(sheets) == ["quantities", "modes", "budget", "consistency", "findings"]
    for name, sheet in sheets.items():
        table = model_hull.to_frame(name)
        assert list(sheet.columns) == list(table.columns)
        assert len(sheet) == len(table)
    wanted = list(model_hull.to_frame("budget")["u_contribution"])
    assert list(sheets["budget"]["u_contribution"]) == pytest.approx(wanted, rel=1e-14)


def test_texts_are_no_formulas_in_a_workbook(model_hull: gyradius.Measurement, tmp_path: Path) -> None:
    swing = replace(model_hull.swings[0], id="=1+1\x07")
    replace(model_hull, swings=(swing,), title="a\x00b").to_xlsx(tmp_path / "t.xlsx")
    cell = openpyxl.load_workbook(tmp_path / "t.xlsx")["modes"]["A2"]
    assert (cell.data_type, cell.value) == ("s", "=1+1\ufffd")


def test_what_cannot_be_made_is_refused(model_hull: gyradius.Measurement, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(gyradius.InputError, match="expected one of quantities, modes"):
        model_hull.to_frame("gyradii")
    for library, extra in (("pandas", "pandas"), ("openpyxl", "xlsx"), ("plotly", "interactive")):
        monkeypatch.setitem(sys.modules, library, None)
        calls: dict[str, Callable[[], Any]] = {
            "pandas": model_hull.to_frame,
            "openpyxl": lambda: model_hull.to_xlsx("never.xlsx"),
            "plotly": lambda: model_hull.plot(interactive=True),
        }
        with pytest.raises(gyradius.InputError, match=rf"gyradius\[{extra}\]"):
            calls[library]()
    assert not Path("never.xlsx").exists()


def test_a_csv_needs_no_pandas(
    model_hull: gyradius.Measurement, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    model_hull.to_csv(tmp_path / "modes.csv", "modes")
    assert (tmp_path / "modes.csv").read_text().startswith("swing,mode,period_s,")


# Simulators.


def figures(text: str, kind: str) -> tuple[float, np.ndarray, np.ndarray]:
    """Mass, centre and matrix as the formats define them, read from the text alone."""
    inertial = ElementTree.fromstring(text)
    if kind == "mjcf":
        mass, pos = float(inertial.attrib["mass"]), inertial.attrib["pos"]
        named = dict(
            zip(("ixx", "iyy", "izz", "ixy", "ixz", "iyz"), inertial.attrib["fullinertia"].split(), strict=True)
        )
    elif kind == "urdf":
        mass, pos = float(inertial.find("mass").attrib["value"]), inertial.find("origin").attrib["xyz"]
        named = dict(inertial.find("inertia").attrib)
    else:
        mass, pos = float(inertial.findtext("mass")), " ".join(inertial.findtext("pose").split()[:3])
        named = {element.tag: element.text for element in inertial.find("inertia")}
    matrix = np.zeros((3, 3))
    for name, (i, j) in PLACES.items():
        matrix[i, j] = matrix[j, i] = float(named[name])
    return mass, np.array(pos.split(), dtype=float), matrix


@pytest.mark.parametrize("kind", ["urdf", "mjcf", "sdf"])
def test_inertial_has_the_figures_of_point_masses(model_hull: gyradius.Measurement, kind: str) -> None:
    mass, centre, inertia = points()
    found = figures(getattr(made_of_points(model_hull), f"to_{kind}")(), kind)
    assert found[0] == pytest.approx(mass, rel=1e-8)
    assert found[1] == pytest.approx([0.0, 0.0, centre[2]], rel=1e-8)
    assert found[2] == pytest.approx(inertia, rel=1e-8, abs=1e-12)
    # High at the bow: −Σ m x z is negative.
    assert found[2][0, 2] < -0.5


def tensor_of(model: Any, body: int) -> np.ndarray:
    """The inertia that MuJoCo compiled, in the body's axes."""
    import mujoco

    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, model.body_iquat[body])
    turn = turn.reshape(3, 3)
    return turn @ np.diag(model.body_inertia[body]) @ turn.T


def test_mujoco_reads_the_body_that_it_builds_of_point_masses(model_hull: gyradius.Measurement) -> None:
    mujoco = pytest.importorskip("mujoco")
    mass, centre, _ = points()
    spheres = "".join(
        f'<geom type="sphere" size="1e-3" mass="{m}" pos="{x - centre[0]} {y} {z}"/>' for (x, y, z), m in POINTS.items()
    )
    wanted = mujoco.MjModel.from_xml_string(
        f"<mujoco><worldbody><body><freejoint/>{spheres}</body></worldbody></mujoco>"
    )
    hull = made_of_points(model_hull)
    # MuJoCo joins the first link of a URDF to the world; the hull hangs on it by a joint.
    inertial = hull.to_urdf()
    urdf = (
        f'<robot name="r"><link name="world"/><link name="hull">{inertial}</link><joint name="j" type="floating">'
        '<parent link="world"/><child link="hull"/></joint></robot>'
    )
    for text in (hull.to_mjcf(model=True), urdf):
        model = mujoco.MjModel.from_xml_string(text)
        assert model.body_mass[1] == pytest.approx(mass, rel=1e-8)
        assert model.body_ipos[1] == pytest.approx(wanted.body_ipos[1], abs=1e-8)
        # Spheres of a millimetre have inertias of their own, of 4e-7 m² of their mass.
        assert np.sort(model.body_inertia[1]) == pytest.approx(np.sort(wanted.body_inertia[1]), abs=1e-5)
        assert tensor_of(model, 1) == pytest.approx(tensor_of(wanted, 1), abs=1e-5)


@pytest.mark.parametrize("kind", ["urdf", "mjcf", "sdf"])
def test_inertial_of_a_session(model_hull: gyradius.Measurement, kind: str) -> None:
    text = getattr(model_hull, f"to_{kind}")()
    mass, centre, inertia = figures(text, kind)
    # As session.toml states it, and the gyradii of the paper's Table 3: 0.310, 0.360, 0.205 m.
    assert mass == pytest.approx(13.18, rel=1e-6)
    assert np.sqrt(np.diag(inertia) / mass) == pytest.approx([0.205, 0.360, 0.310], abs=0.002)
    assert centre[2] == pytest.approx(-model_hull.quantities["cm_depth_m"].value, rel=1e-8)
    # Bow up: tan 2ψ = −2 I_xz / (I_zz − I_xx).
    psi = 0.5 * np.degrees(np.arctan2(-2 * inertia[0, 2], inertia[2, 2] - inertia[0, 0]))
    assert psi == pytest.approx(model_hull.quantities["psi_deg"].value, abs=0.01)
    for words in ("hull alone", "x forward, y to port, z up", "mid-point of the suspension points", "UNKNOWN"):
        assert words in text


def test_whole_models_have_one_body(model_hull: gyradius.Measurement) -> None:
    paths = {"urdf": "link/inertial", "mjcf": "worldbody/body/inertial", "sdf": "model/link/inertial"}
    for kind, path in paths.items():
        root = ElementTree.fromstring(getattr(model_hull, f"to_{kind}")(model=True))
        assert len(root.findall(path)) == 1


def changed(copy_of: Callable[[str], Path], change: Callable[[str], str]) -> gyradius.Measurement:
    path = copy_of("model-hull")
    file = path / "session.toml"
    file.write_text(change(file.read_text(encoding="utf-8")), encoding="utf-8")
    return gyradius.load(path).measure()


def test_attachments_are_not_part_of_the_body(copy_of: Callable[[str], Path]) -> None:
    attachment = "[[attachment]]\nname = 'phone'\nmass = { value = 0.25, u = 0.001 }\nposition = [0.0, 0.0, -0.2]\n\n"
    found = changed(copy_of, lambda text: text.replace("[[swing]]", attachment + "[[swing]]", 1))
    assert figures(found.to_urdf(), "urdf")[0] == pytest.approx(13.18 - 0.25, rel=1e-6)


def test_without_a_mass_there_is_no_inertial(copy_of: Callable[[str], Path]) -> None:
    found = changed(copy_of, lambda text: re.sub("(?m)^mass = .*$", "", text))
    with pytest.raises(gyradius.NoResultError, match=r"state `mass` in \[body\]"):
        found.to_mjcf()


def test_without_pitch_and_roll_there_is_no_inertial(keelboat: gyradius.Measurement) -> None:
    with pytest.raises(gyradius.NoResultError, match="do not determine k_roll_m, k_pitch_m"):
        keelboat.to_sdf()


def test_moments_of_no_body_are_refused(model_hull: gyradius.Measurement) -> None:
    inertia = replace(model_hull.quantities["inertia_kg_m2"], value=((1.0, 0, 0), (0, 3.0, 0), (0, 0, 1.0)))
    with pytest.raises(gyradius.NoResultError, match="no body has the principal moments"):
        replace(model_hull, quantities={**model_hull.quantities, "inertia_kg_m2": inertia}).to_urdf()


def test_unknown_figures_are_said(model_hull: gyradius.Measurement) -> None:
    (xx, xy, _), y, (_, zy, zz) = model_hull.quantities["inertia_kg_m2"].value
    along = gyradius.Quantity(((xx, xy, 0.0), y, (0.0, zy, zz)), ((0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.1)), "along")
    quantities = {name: q for name, q in model_hull.quantities.items() if name != "cm_depth_m"}
    text = replace(model_hull, quantities={**quantities, "inertia_kg_m2": along}).to_urdf()
    assert "ixz is UNKNOWN" in text
    assert "Origin: the centre of mass" in text
    assert figures(text, "urdf")[1] == pytest.approx([0.0, 0.0, 0.0])


def test_a_title_cannot_end_the_comment(model_hull: gyradius.Measurement) -> None:
    text = replace(model_hull, title="a--><mass value='1'/>\x00\n--\u00e9").to_urdf()
    assert ElementTree.fromstring(text).find("mass").attrib["value"] == "13.18"


# The command.


@pytest.mark.parametrize(("ending", "root"), [(".urdf", "robot"), (".sdf", "sdf"), (".xml", "mujoco")])
def test_command_writes_simulators_files(tmp_path: Path, ending: str, root: str) -> None:
    target = tmp_path / f"hull{ending}"
    done = run("export", gyradius.shipped_session("model-hull"), "-o", target)
    assert done.returncode == 0, done.stderr
    assert f"Export: {target}" in done.stdout
    assert ElementTree.parse(target).getroot().tag == root


def test_command_writes_tables_and_the_json_of_measure(tmp_path: Path, model_hull: gyradius.Measurement) -> None:
    session = gyradius.shipped_session("model-hull")
    done = run("export", session, "-o", tmp_path / "m.csv", "--table", "modes", "--json", "-")
    assert done.returncode == 0, done.stderr
    assert done.stdout == model_hull.to_json() + "\n"
    model_hull.to_csv(tmp_path / "wanted.csv", "modes")
    assert (tmp_path / "m.csv").read_bytes() == (tmp_path / "wanted.csv").read_bytes()
    assert run("export", session, "-o", tmp_path / "m.XLSX").returncode == 0
    assert openpyxl.load_workbook(tmp_path / "m.XLSX").sheetnames == [table.value for table in Table]


def test_command_refuses_what_it_cannot_write(tmp_path: Path) -> None:
    session = gyradius.shipped_session("keelboat")
    assert_refused(run("export", session, "-o", tmp_path / "hull.stl"), 2, "hull.stl", ".csv", ".urdf")
    assert_refused(run("export", session, "-o", tmp_path / "no" / "hull.csv"), 2, "No such file")
    assert_refused(run("export", session, "-o", tmp_path / "hull.xlsx", "--table", "modes"), 2, "--table modes")
    done = run("export", session, "-o", tmp_path / "hull.urdf", "--json", tmp_path / "hull.json")
    assert_refused(done, 1, "do not determine k_roll_m, k_pitch_m")
    assert parsed((tmp_path / "hull.json").read_text())["error"]["kind"] == "no_result"  # type: ignore[index]
    assert not (tmp_path / "hull.urdf").exists()


NOTHING_DETERMINED = """\
format = "gyradius-session/1"
[body]
mass = 100.0
[[swing]]
id = "sway"
periods_s = { sway = { value = 2.8, u = 0.004 } }
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = 2.0
spacing = 1.0
"""


def test_command_on_what_gives_modes_alone(tmp_path: Path, folder: Callable[..., Path]) -> None:
    recording = tmp_path / "yaw.csv"
    recording.write_text(swing_csv())
    done = run("export", recording, "-o", tmp_path / "modes.csv", "--table", "modes")
    assert done.returncode == 0, done.stderr
    with (tmp_path / "modes.csv").open() as file:
        assert float(next(csv.DictReader(file))["period_s"]) == pytest.approx(2.0, abs=1e-3)
    session = folder(NOTHING_DETERMINED)
    done = run("export", session, "-o", tmp_path / "all.xlsx", "--json", tmp_path / "all.json")
    assert_refused(done, 1)
    assert "Export:" in done.stdout
    assert openpyxl.load_workbook(tmp_path / "all.xlsx")["modes"].max_row == 2
    assert parsed((tmp_path / "all.json").read_text())["error"]["kind"] == "no_result"  # type: ignore[index]


def test_the_choices_of_the_command_are_the_tables() -> None:
    assert [table.value for table in Table] == list(TABLES)


def test_a_mass_that_the_axes_do_not_agree_on_is_told(keelboat: gyradius.Measurement) -> None:
    """1 % of a gyradius is 2 % of the mass."""
    measurement = made_of_points(keelboat)
    assert "Known to" not in measurement.to_urdf()
    k = measurement.quantities["k_yaw_m"]
    other = {**measurement.quantities, "k_yaw_m": replace(k, value=k.value / 1.01)}
    assert "Known to 2 % only" in replace(measurement, quantities=other).to_urdf()
