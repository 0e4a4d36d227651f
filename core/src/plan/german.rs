//! The sentences of the plan's warnings in German, by the same kinds as in English.

use super::warnings::WarningKind;

/// Sentences by kind; `{name}` stands for a number, a name or the swing.
pub const GERMAN: [(WarningKind, &str); 8] = [
    (
        WarningKind::YawNearInPhase,
        "Schwingung {swing}: Gieren ({yaw_period_s} s) und das gleichphasige Pendeln ({in_phase_period_s} s) liegen {apart_percent} % \
         auseinander und regen einander an (Kane und Tseng): Gieren und Querschwingen einzeln anregen, oder Leinenlänge oder \
         Abstand ändern.",
    ),
    (
        WarningKind::NoBeat,
        "Schwingung {swing}: ein Abstand von {spacing_m} m liegt so nahe am doppelten Gierträgheitsradius ({twice_k_yaw_m} m), dass \
         Gieren und Querschwingen in {duration_s} s keine Schwebung zeigen: hier keine Schwebungen zählen.",
    ),
    (
        WarningKind::SlackLine,
        "Schwingung {swing}: bei {amplitude_deg}° Auslenkung wird nach {t_s} s eine Leine lose: weniger auslenken (schräg längs der \
         Aufhängung allein müssen die Leinen unter {most_lean_deg}° bleiben).",
    ),
    (
        WarningKind::TiltNeeded,
        "Schwingung {swing} hängt geneigt, {tilt_deg}° (Bug nach oben positiv): die Punkte um {points_moved_m} m längs des Decks \
         versetzen (nach vorn positiv; die Ecken des Rahmens gäben {corner_tilt_deg}°) und die Neigung am Telefon ablesen.",
    ),
    (
        WarningKind::SpacingTooShort,
        "{quantity} erreicht u = {reached_percent} %, nicht {wanted_percent} %: der Abstand von {spacing_m} m, auf {u_input_mm} mm \
         bekannt, begrenzt es. Auf {u_input_needed_mm} mm messen; mit diesem Maßband müssten die Punkte {spacing_needed_m} m \
         auseinander liegen.",
    ),
    (
        WarningKind::NotReached,
        "{quantity} erreicht u = {reached_u}, nicht {wanted_u}: das meiste kommt von {input} ({contribution_u}), das \
         {times_better}-mal genauer bekannt sein müsste.",
    ),
    (WarningKind::NotDetermined, "{quantity} wird von diesen Schwingungen nicht bestimmt."),
    (
        WarningKind::RoughHull,
        "{quantity} des Rumpfs ist nur auf {u_percent} % bekannt, und was daraus vorhergesagt wird, nicht besser: mit der Sitzung \
         der ersten Schwingung neu planen.",
    ),
];
