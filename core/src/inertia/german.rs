//! Names of quantities and routes in German: the same keys as in English.

/// Quantities by their key.
pub const QUANTITIES: [(&str, &str); 5] = [
    ("k_yaw_m", "Trägheitsradius Gieren"),
    ("k_pitch_m", "Trägheitsradius Stampfen"),
    ("k_roll_m", "Trägheitsradius Rollen"),
    ("cm_depth_m", "Tiefe des Schwerpunkts"),
    ("psi_deg", "Neigung der Hauptachse"),
];

/// Routes by their method.
pub const ROUTES: [(&str, &str); 16] = [
    ("yaw_period", "Gierperiode mit Leinenlänge und Abstand"),
    ("period_ratio", "Gierperiode durch Querperiode, mal dem halben Abstand"),
    ("beat_count", "Schwingungen je Schwebung von Gieren und Querschwingen"),
    ("double_pendulum", "beide Perioden des Doppelpendels, Querperiode als Uhr"),
    ("double_pendulum_and_line_length", "beide Perioden des Doppelpendels, mit der Leinenlänge"),
    ("compound", "physikalisches Pendel"),
    ("compound_pendulum", "physikalisches Pendel"),
    ("lamboley", "physikalisches Pendel in zwei Höhen (Lamboley)"),
    ("incline", "Neigen mit einem Gewicht"),
    ("tilted_yaw", "Gieren waagerecht und bei zwei Neigungen"),
    ("tilted_yaw_right_angle", "Gieren waagerecht und bei zwei Neigungen im rechten Winkel"),
    ("one_tilt", "Rollen, Gieren und ein geneigtes Gieren"),
    ("tilt_fit", "Gieren bei allen Neigungen, nach kleinsten Quadraten"),
    ("points_moved", "Verschieben der Aufhängepunkte und die Neigung, die folgt"),
    ("incline_both_ends", "Neigen an Bug und Heck"),
    ("joint_estimate", "gemeinsame Schätzung aus der ganzen Messung"),
];
