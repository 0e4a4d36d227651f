"""The paper, recomputed: every table and figure is there, and what differs from the print is in the errata.

Expected numbers stand in the paper or in its errata, or come from closed forms and scipy here.
"""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import SHARED, assert_refused, parsed, run

from gyradius.paper import FORMAT, Check, Computed, Paper, PaperFigure, errata, printed, recompute, write_files
from gyradius.paper.amplitude import pendulum_longer, period_ratio, yaw_longer
from gyradius.paper.double_pendulum import modes
from gyradius.paper.ellipsoids import figure_1, tilt_fit
from gyradius.paper.keelboat import with_masses
from gyradius.paper.lengths import best_line_length_m, curves_15, loaded_model
from gyradius.paper.print_data import all_printed
from gyradius.paper.rigs import keelboat, model, model_lines

FIGURES = ("1", "3", "4", "6", "7", "8", "9", *map(str, range(11, 25)))
TABLES = ("Table 1", "Table 2", "Table 3", "Table 4 (first)", "Table 4 (second)", "Text")
# The printed numbers that do not come out, and the erratum of each.
DIFFERENT = {
    "fig1.k_py": "fig1-labels",
    "fig1.k_pz": "fig1-labels",
    "table3.psi_bow_down": "psi-sign",
    "table3.psi_stern_down": "psi-sign",
    "fig22.far_slope": "far-slope",
    "air.period_over_tau": "period-over-tau",
}
GRAVITY = 9.80665
PAPER_TEXT = SHARED / "paper" / "hinrichsen-2014.txt"
# Our words for these, or converted: the print has 2d = 1800 mm, degrees as "30°", an exponent, g/ml.
REWORDED = {"keelboat.half_spacing", "air.correction", "air.air_density", "air.hull_density", "air.period_over_tau"}


@pytest.fixture(scope="module")
def paper() -> Paper:
    """All of it, once."""
    return recompute()


def figure(paper: Paper, number: str) -> PaperFigure:
    return next(one for one in paper.figures if one.number == number)


def computed(paper: Paper, id_: str) -> float:
    """The computed number beside a printed one, in the unit of the print."""
    return next(check for check in paper.checks if check.printed.id == id_).computed_in_unit


def test_every_figure_and_table_is_there(paper: Paper) -> None:
    assert tuple(one.number for one in paper.figures) == FIGURES
    assert tuple(one.heading for one in paper.tables) == TABLES
    drawn_or_not = {int(number) for number in FIGURES} | {int(number) for number, _ in paper.without_data}
    assert drawn_or_not == set(range(1, 27))


def test_numbers_agree_within_rounding_or_have_an_erratum(paper: Paper) -> None:
    found = {check.printed.id: check.erratum for check in paper.checks if check.verdict == "differs"}
    assert found == DIFFERENT
    # An erratum explains a difference, and nothing else.
    assert {check.printed.id for check in paper.checks if check.erratum} == set(DIFFERENT)
    assert all(check.verdict == "reproduced" for check in paper.round_trips)
    assert paper.counts() == {"reproduced": 46, "input rounding": 12, "differs": 6}


def test_every_erratum_is_told_somewhere(paper: Paper) -> None:
    parts = [*paper.tables, *paper.figures]
    told = {id_ for part in parts for id_ in part.errata} | {check.erratum for check in paper.checks}
    assert set(errata()) == told - {None}


def test_verdict_at_its_limits() -> None:
    period = replace(printed("table1.1.period"), text="4.391", rounding_in_unit=0.0005)

    def verdict(value: float, spread: float = 0.0) -> str:
        return Check("period", period, Computed(value, spread, "")).verdict

    assert verdict(4.3915) == verdict(4.3905) == "reproduced"
    assert verdict(4.3916) == verdict(4.3904) == "differs"
    assert verdict(4.3916, 0.0002) == "input rounding"
    assert verdict(4.3916, 0.00005) == "differs"
    bound = replace(period, text="<0.07")
    assert Check("bound", bound, Computed(0.0699, 0.0, "")).verdict == "reproduced"
    assert Check("bound", bound, Computed(0.0701, 0.0, "")).verdict == "differs"


def test_a_wrong_number_is_noticed(paper: Paper) -> None:
    """A digit that is printed wrong must not pass: two units of the last digit beyond all rounding."""
    for check in paper.checks:
        if check.verdict == "differs" or check.printed.is_bound:
            continue
        beyond = 2.1 * (check.printed.rounding_in_unit + check.spread_in_unit)
        wrong = replace(check.printed, text=f"{check.computed_in_unit + beyond!r}")
        assert replace(check, printed=wrong).verdict == "differs", check.label


@pytest.mark.skipif(not PAPER_TEXT.is_file(), reason="no ../shared/paper beside this clone")
def test_printed_numbers_stand_in_the_paper() -> None:
    numbers = set(re.findall(r"\d+(?:\.\d+)?", PAPER_TEXT.read_text(encoding="utf-8").replace(",", "")))
    whole = {number for number in numbers if "." not in number}
    for id_, one in all_printed().items():
        if id_ in REWORDED:
            continue
        text = one.text.strip("-<")
        assert text in numbers or text.rstrip("0").rstrip(".") in numbers or text.split(".")[0] in whole, id_
        assert text in numbers or not id_.startswith("table"), id_


# Numbers of the paper's errata, and closed forms.


def test_table_1_and_line_of_figure_7(paper: Paper) -> None:
    expected = 4.391 * 0.9 / (2.0 * math.pi) * math.sqrt(GRAVITY / 3.477)
    assert computed(paper, "table1.1.gyradius") == pytest.approx(1e3 * expected, rel=1e-12)
    assert computed(paper, "table1.1.gyradius") == pytest.approx(1056.3, abs=0.05)
    found = [1e3 * with_masses(mass).value for mass in (1.2, 2.4, 3.6)]
    assert found == pytest.approx([1069.9, 1082.9, 1095.6], abs=0.05)
    assert figure(paper, "7").drawing.axes[0].lines[1].get_xydata() == pytest.approx(
        np.array([(0, 1056.6), (0, 1056.4), (0, 1054.7), (1.2, 1069.9), (2.4, 1083.8), (2.4, 1082.0), (3.6, 1096.1)])
    )


def test_table_2_contradicts_its_line_length(paper: Paper) -> None:
    table = paper.tables[1]
    assert "3.591 m and 3.625 m" in table.remark
    assert 3.802**2 * GRAVITY / (4.0 * math.pi**2) == pytest.approx(3.591, abs=0.0005)


def test_psi_and_roll_gyradius(paper: Paper) -> None:
    assert computed(paper, "table3.psi_bow_down") == pytest.approx(5.72, abs=0.005)
    assert computed(paper, "table3.psi_stern_down") == pytest.approx(5.55, abs=0.005)
    assert computed(paper, "table3.7.k_roll") == pytest.approx(204.8, abs=0.05)
    # The least-squares ellipse by numpy: k² is linear in the elements of the tensor.
    tilts = np.radians([0.0, -31.1, 22.8, 90.0])
    squares = np.array([0.310, 0.294, 0.290, 0.204]) ** 2
    weights = 0.5 / np.sqrt(squares)
    columns = np.stack([np.sin(tilts) ** 2, np.cos(tilts) ** 2, np.sin(2.0 * tilts)], axis=1)
    roll, yaw, product = np.linalg.lstsq(columns * weights[:, None], squares * weights, rcond=None)[0]
    psi = 0.5 * math.atan(2.0 * product / (roll - yaw))
    assert tilt_fit()["psi_rad"] == pytest.approx(psi, abs=1e-4)


def test_periods_of_figure_15() -> None:
    expected = {
        0.504: (0.997, 2.006, 1.424, 1.541),
        1.006: (1.192, 2.370, 2.012, 2.178),
        1.560: (1.272, 2.766, 2.506, 2.712),
    }
    for length, periods in expected.items():
        found = curves_15(length)
        names = ("out_of_phase", "in_phase", "sway", "yaw")
        assert [found[name] for name in names] == pytest.approx(periods, abs=0.0005)


def test_best_lengths_of_figure_17() -> None:
    assert best_line_length_m(0.352, 0.253, 1.0) == pytest.approx(0.498, abs=0.0005)
    assert best_line_length_m(0.352, 0.253, 0.0) == pytest.approx(0.29, abs=0.005)
    # Where the slope has no minimum there is no point.
    assert math.isnan(best_line_length_m(1.0, 1.0, 0.0))


def test_amplitudes_of_figure_23() -> None:
    found = [1e6 * yaw_longer(angle) for angle in (1.0, 2.0, 5.0, 8.0, 10.0, 15.0)]
    assert found == pytest.approx([19, 76, 473, 1211, 1893, 4263], abs=0.5)
    angle = math.radians(10.0)
    series = angle**2 / 16.0 + 11.0 * angle**4 / 3072.0
    assert pendulum_longer(10.0) == pytest.approx(series, rel=1e-4)


def test_hull_and_keel(paper: Paper) -> None:
    assert computed(paper, "table4.both.i_pitch") == pytest.approx(622.7 * 1.156**2)
    rest = 622.7 * 1.156**2 - 306.2 * 0.339**2 - 306.2 * 316.5 / 622.7 * (0.058**2 + 0.923**2)
    assert computed(paper, "table4.hull.k_pitch") == pytest.approx(1e3 * math.sqrt(rest / 316.5))
    assert computed(paper, "table4.offset_i_yaw") == pytest.approx(0.52, abs=0.005)
    assert computed(paper, "table4.both.x") == pytest.approx((316.5 * 3083 + 306.2 * 3141) / 622.7)


def test_slopes_of_figure_22(paper: Paper) -> None:
    def slope(degrees: float) -> float:
        angle = math.radians(degrees)
        k2 = (0.623 * math.sin(angle)) ** 2 + (1.058 * math.cos(angle)) ** 2
        return (1.058**2 - 0.623**2) * math.sin(angle) * math.cos(angle) / math.sqrt(k2) * 1e3 * math.pi / 180.0

    assert computed(paper, "fig22.pitch_slope") == pytest.approx(slope(3.0), rel=1e-5)
    assert computed(paper, "fig22.far_slope") == pytest.approx(slope(21.0), rel=1e-5)
    # What the erratum says of the print's 3 mm/deg.
    assert slope(15.0) == pytest.approx(3.1, abs=0.05)


def test_modes_of_figure_11_are_those_of_the_linear_double_pendulum() -> None:
    linalg = pytest.importorskip("scipy.linalg")
    hull, lines = model(1), model_lines(1)
    l1, l2, k = lines.line_length_m, hull.cm_depth_m, hull.k_pitch_m
    inertia = np.array([[l1 * l1, l1 * l2], [l1 * l2, l2 * l2 + k * k]])
    squares, shapes = linalg.eigh(GRAVITY * np.diag([l1, l2]), inertia)
    for mode, square, (line, turn) in zip(modes(hull, lines).values(), squares, shapes.T, strict=True):
        # A finite start of 2 cm makes periods longer by some 1e-3 at most.
        assert mode.period_s == pytest.approx(2.0 * math.pi / math.sqrt(square), rel=1e-3)
        assert mode.turn_per_m == pytest.approx(turn / (l1 * line + l2 * turn), rel=5e-3)


def test_masses_of_figure_18_by_parallel_axes() -> None:
    found, mass, added = loaded_model(0.1), 13.18, 0.1
    total = mass + 2.0 * added
    depth = mass * 0.253 / total
    along = added * (0.883 - 0.859) / total
    moment = mass * (0.352**2 + (0.253 - depth) ** 2 + along**2)
    moment += added * ((0.883 - along) ** 2 + (0.859 + along) ** 2 + 2.0 * depth**2)
    assert found["depth"] == pytest.approx(depth)
    assert found["k_pitch"] == pytest.approx(math.sqrt(moment / total))


def test_ratio_of_figure_24_falls_as_a_pendulum_slows() -> None:
    still, wide = (period_ratio(keelboat(1.0566), sway) for sway in (0.02, 0.3))
    assert still == pytest.approx(1.0566 / 0.9, rel=3e-4)
    assert wide < still * (1.0 - 1e-3)


def test_suspensions_of_the_first_table_4(paper: Paper) -> None:
    words = paper.tables[3].words
    assert [one.label for one in words if not one.agrees] == ["A-C+G-E", "A-G+C-E"]
    # A compound pendulum depends on the depth too; the gyradius is the printed one.
    assert all(set(one.printed.split(", ")) <= set(one.found.split(", ")) for one in words)


def test_axes_have_names_and_drawings_no_gaps(paper: Paper) -> None:
    for one in paper.figures:
        axes = one.drawing.axes
        assert any(panel.get_xlabel() for panel in axes), one.number
        assert any(panel.get_ylabel() for panel in axes), one.number
        for name in [text for panel in axes for text in (panel.get_xlabel(), panel.get_ylabel()) if text]:
            assert ", " in name or re.match(r"L12|K_P2|best L12|T_y|slope", name), (one.number, name)


def test_command_writes_page_figures_tables_and_json(tmp_path: Path) -> None:
    target = tmp_path / "out"
    done = run("paper", "-o", target, "--json", tmp_path / "paper.json")
    assert done.returncode == 0, done.stderr
    assert "46 agree within their own rounding" in done.stdout
    data = parsed((tmp_path / "paper.json").read_text(encoding="utf-8"))
    assert data["format"] == FORMAT == "gyradius-paper/1"
    summary = data["summary"]
    assert isinstance(summary, dict)
    assert summary["differs"] == len(DIFFERENT)
    for kind in ("tables", "figures"):
        parts = json.loads(json.dumps(data[kind]))
        assert all((target / part["file"]).stat().st_size > 100 for part in parts), kind
    for file in (target / "figures").iterdir():
        assert ElementTree.parse(file).getroot().tag.endswith("svg")
    html, text = ((target / name).read_text(encoding="utf-8") for name in ("paper.html", "paper.md"))
    assert html.count("data:image/svg+xml") == len(FIGURES)
    # Self-contained: nothing is fetched.
    assert not re.search(r'(src|href)="(?!data:|#)', html)
    for page in (html, text):
        assert "What does not agree" in page
        assert all(f"Figure {number}:" in page for number in FIGURES)
        assert all(f"{heading}:" in page for heading in TABLES)


def test_a_folder_that_cannot_be_made_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_text("", encoding="utf-8")
    assert_refused(run("paper", "-o", file, "--json", tmp_path / "paper.json"), 2, "file")
    assert parsed((tmp_path / "paper.json").read_text(encoding="utf-8"))["format"] == FORMAT


def test_a_number_that_is_not_in_the_data_is_refused() -> None:
    with pytest.raises(ValueError, match=r"nothing.*printed.csv"):
        printed("nothing")


def test_writing_twice_gives_the_same_files(paper: Paper, tmp_path: Path) -> None:
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        write_files(Paper(paper.tables[:1], (figure_1(),), ()), tmp_path / name)
    for file in ("paper.html", "paper.md", "figures/figure-01.svg", "tables/table-1.csv"):
        assert (tmp_path / "one" / file).read_bytes() == (tmp_path / "two" / file).read_bytes()
