//! The sentences of the advice in German, by the same keys as in English.

/// Sentences by key; `{name}` stands for a parameter.
pub const GERMAN: [(&str, &str); 12] = [
    (
        "sensor_silent",
        "Der {sensor} liefert seit {since_s} s keine Werte mehr: Aufnahme beenden und neu beginnen.",
    ),
    (
        "sensor_absent",
        "Der {sensor} liefert keine Werte: Aufnahme beenden und neu beginnen.",
    ),
    (
        "phone_moved",
        "Das Telefon hat sich bei {at_s} s bewegt und liegt nun um {tilt_deg}° anders: festkleben und neu beginnen.",
    ),
    (
        "touched",
        "Bei {at_s} s hat etwas den Rumpf berührt: frei schwingen lassen oder neu auslenken.",
    ),
    (
        "saturated",
        "{samples} Werte des {sensor}s liegen an seiner Grenze: mit kleinerem Ausschlag loslassen.",
    ),
    (
        "gaps",
        "Der {sensor} hat {gaps} Lücken, die längste von {longest_s} s: andere Apps schließen und den Bildschirm anlassen.",
    ),
    (
        "amplitude_low",
        "Der Ausschlag ist {amplitude_deg}°, unter 2°: beenden oder neu auslenken.",
    ),
    (
        "sway",
        "Querschwingen (Periode {period_s} s) mit {percent} % der Hauptbewegung: Rumpf beruhigen und neu auslenken.",
    ),
    (
        "other_turn",
        "Drehung um eine andere Achse (Periode {period_s} s) mit {percent} % der Hauptbewegung: Rumpf beruhigen und neu \
         auslenken.",
    ),
    (
        "same_turn",
        "Eine zweite Bewegung (Periode {period_s} s) mit {percent} % der Hauptbewegung: Rumpf beruhigen und neu auslenken.",
    ),
    (
        "out_of_reach",
        "Die Schwingung klingt ab, bevor die Periode so sicher ist wie gewünscht: neu auslenken.",
    ),
    (
        "long_enough",
        "Die Aufnahme ist lang genug: beenden, wann Sie wollen.",
    ),
];
