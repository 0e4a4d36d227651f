//! What is said of a measurement, and its names, in German: the same keys as in English.

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
    (
        "period_ratio",
        "Gierperiode durch Querperiode, mal dem halben Abstand",
    ),
    (
        "beat_count",
        "Schwingungen je Schwebung von Gieren und Querschwingen",
    ),
    (
        "double_pendulum",
        "beide Perioden des Doppelpendels, Querperiode als Uhr",
    ),
    (
        "double_pendulum_and_line_length",
        "beide Perioden des Doppelpendels, mit der Leinenlänge",
    ),
    ("compound", "physikalisches Pendel"),
    ("compound_pendulum", "physikalisches Pendel"),
    ("lamboley", "physikalisches Pendel in zwei Höhen (Lamboley)"),
    ("incline", "Neigen mit einem Gewicht"),
    ("tilted_yaw", "Gieren waagerecht und bei zwei Neigungen"),
    (
        "tilted_yaw_right_angle",
        "Gieren waagerecht und bei zwei Neigungen im rechten Winkel",
    ),
    ("one_tilt", "Rollen, Gieren und ein geneigtes Gieren"),
    (
        "tilt_fit",
        "Gieren bei allen Neigungen, nach kleinsten Quadraten",
    ),
    (
        "points_moved",
        "Verschieben der Aufhängepunkte und die Neigung, die folgt",
    ),
    ("incline_both_ends", "Neigen an Bug und Heck"),
    (
        "joint_estimate",
        "gemeinsame Schätzung aus der ganzen Messung",
    ),
];

/// Sentences by key; `{name}` stands for an argument.
pub const SENTENCES: [(&str, &str); 22] = [
    (
        "stated",
        "{name}: angegeben {stated}; nach {by} sind es {implied}: {verdict} ({sigma} Standardunsicherheiten).",
    ),
    ("by_sway", "der Querperiode von {swing}"),
    ("by_all", "allen Schwingungen zusammen ({inputs})"),
    (
        "against",
        "{quantity}: {first} ({one}; {one_from}) gegen {second} ({other}; {other_from}): {verdict} ({sigma} Standardunsicherheiten der Differenz).{pairs}",
    ),
    (
        "pairs",
        " Dieselben zwei Wege liegen bei {count} Paaren von Schwingungen um {least} bis {most} auseinander.",
    ),
    ("agree", "beides stimmt überein"),
    ("contradict", "beides widerspricht sich"),
    (
        "no_gravity",
        "Weder Schwerkraft noch Breitengrad sind angegeben: es gilt die Normalfallbeschleunigung mit u = 0,015 m/s²",
    ),
    ("no_joint_estimate", "Keine gemeinsame Schätzung: {reason}"),
    (
        "widened",
        "Die Messung widerspricht sich (χ² = {chi2} bei {dof} Freiheitsgraden): alle Unsicherheiten sind auf das {factor}-Fache erweitert",
    ),
    ("no_verdict", "Kein Urteil über {quantity}: {reason}"),
    (
        "no_verdict_undetermined",
        "Kein Urteil über {quantity}: die Schwingungen bestimmen es nicht",
    ),
    (
        "no_single_period",
        "Der Eintrag bei {at_s} s ({period_s} s) ist keine einzelne Periode dieser Bewegung: weggelassen",
    ),
    (
        "bare_recording",
        "Eine Aufnahme allein ergibt nur Schwingungsformen und Perioden; erst eine Messung mit Maßen ergibt Trägheitsradien",
    ),
    (
        "yaw_by_word",
        "Kein Beschleunigungssensor, der die Schwerkraft sieht: die Senkrechte ist unbekannt, und die stärkste Schwingung heißt nur auf das Wort des Bedieners hin Gieren",
    ),
    (
        "no_shapes",
        "Kein Beschleunigungssensor, der die Schwerkraft sieht: die Senkrechte ist unbekannt, und die Schwingungen lassen sich nicht nach ihrer Form benennen",
    ),
    (
        "track_alone",
        "Ein Weg allein zeigt keine Formen: die Schwingungen sind nach ihren Perioden benannt",
    ),
    (
        "not_seen",
        "{motion} sollte angeregt werden, zeigt sich aber nicht in den Daten",
    ),
    (
        "not_meant",
        "Die stärkste Bewegung ist {motion}, das nicht angeregt werden sollte",
    ),
    (
        "parasitic",
        "Ungewollt: {motion} mit {percent} % der stärksten Bewegung",
    ),
    ("of", "{what} von {which}"),
    ("an_id", "{id}"),
];

/// Motions by their names in English.
pub const MOTIONS: [(&str, &str); 11] = [
    ("yaw", "Gieren"),
    ("sway", "Querschwingen"),
    ("surge", "Längsschwingen"),
    ("pitch", "Stampfen"),
    ("roll", "Rollen"),
    ("pitch in phase", "Stampfen im Gleichtakt"),
    ("pitch out of phase", "Stampfen im Gegentakt"),
    ("roll in phase", "Rollen im Gleichtakt"),
    ("roll out of phase", "Rollen im Gegentakt"),
    ("compound pendulum", "Schwingen als physikalisches Pendel"),
    ("unnamed motion", "unbenanntes Schwingen"),
];

/// Inputs of budgets by their labels.
pub const INPUTS: [(&str, &str); 25] = [
    ("gravity", "Schwerkraft"),
    ("phone clock", "Uhr des Telefons"),
    ("mass", "Masse"),
    ("gyradius", "Trägheitsradius"),
    ("product xz", "Deviationsmoment"),
    ("depth", "Schwerpunkttiefe"),
    ("line length", "Leinenlänge"),
    ("spacing", "Abstand der Leinen"),
    ("top spacing", "Abstand der Leinen oben"),
    ("axis height", "Höhe der Achse"),
    ("hull pitch", "Längsneigung des Rumpfs"),
    ("suspension points", "Aufhängepunkte"),
    ("incline bow", "Neigungsversuch am Bug"),
    ("incline stern", "Neigungsversuch am Heck"),
    ("samples", "Messwerte"),
    (
        "finite-amplitude correction",
        "Korrektur für endliche Amplitude",
    ),
    (
        "unknown tilt of the principal axes",
        "unbekannte Neigung der Hauptachsen",
    ),
    ("yaw period", "Gierperiode"),
    ("sway period", "Querperiode"),
    ("pitch in phase period", "Stampfperiode im Gleichtakt"),
    ("pitch out of phase period", "Stampfperiode im Gegentakt"),
    ("roll in phase period", "Rollperiode im Gleichtakt"),
    ("roll out of phase period", "Rollperiode im Gegentakt"),
    (
        "compound pendulum period",
        "Periode als physikalisches Pendel",
    ),
    (
        "unnamed motion period",
        "Periode einer unbenannten Schwingung",
    ),
];
