//! Sentences of the criticism by key, in German: the same keys as in English.

/// Sentences by key; `{name}` stands for an argument.
pub const GERMAN: &[(&str, &str)] = &[
    (
        "adequate",
        "Die Simulation erklärt alles, was die Aufnahmen zeigen.",
    ),
    ("explained", "Was die Simulation ausließ: {causes}."),
    (
        "ambiguous",
        "Was die Simulation ausließ: {causes}; diese Aufnahmen können das aber nicht unterscheiden von: {others}.",
    ),
    (
        "unexplained",
        "Auf den Rumpf oder das Telefon wirkt etwas, das keine bekannte Ursache erklärt.",
    ),
    (
        "many",
        "Es braucht {count} Ursachen zugleich, um zu erklären, was die Aufnahmen zeigen ({causes}): eher wirkt etwas, das nicht bekannt ist.",
    ),
    (
        "remains",
        "Die Simulation ließ aus: {causes}; und es bleibt etwas, das keine bekannte Ursache erklärt.",
    ),
    ("and_also", "{one}, und {other}"),
    ("or_also", "{one}; oder: {other}"),
    ("row", "{one}, {other}"),
    ("and", "{one} und {other}"),
    ("or", "{one} oder {other}"),
    ("cause", "{^cause}."),
    (
        "next_lines",
        "{^excited}{hull} um {amplitude_deg}° an Leinen von {line_length_m} m, {spacing_m} m auseinander, {duration_s} s lang: die Vorhersagen für {one} und {other} liegen dann {sigma} Standardabweichungen auseinander",
    ),
    ("next_bow_up", " mit dem Bug {pitch_deg}° hoch"),
    ("next_bow_down", " mit dem Bug {pitch_deg}° tief"),
    (
        "next_same",
        "Ebenso gehängt, bei {amplitude_deg}° losgelassen, {duration_s} s lang: die Vorhersagen für {one} und {other} liegen dann {sigma} Standardabweichungen auseinander",
    ),
    (
        "next_periods",
        "Eine Schwingung an Leinen von {line_length_m} m, {spacing_m} m auseinander, angestoßen: {excited}, würde {causes} unterscheiden von {others} (Perioden von {modes}, mindestens {sigma} Standardabweichungen).{left}",
    ),
    ("next_leaves", " Offen bleibt: {causes}."),
    ("channel_turn", "Drehrate um die {axis}-Achse des Telefons"),
    (
        "channel_force",
        "Beschleunigung längs der {axis}-Achse des Telefons",
    ),
    ("channel_swing", "Drehrate um die Achse der Schwingung"),
    (
        "structure",
        "{swing}: die Simulation lässt das {rms}-Fache des Rauschens übrig, und was sie übrig lässt, ist kein Rauschen",
    ),
    (
        "line",
        "{swing}: bei etwa {middle_hz} Hz bewegt sich {channel} um das {size}-Fache des Rauschens mehr als simuliert",
    ),
    ("line_gyroscope", "die {axis}-Achse des Drehratensensors"),
    (
        "line_accelerometer",
        "die {axis}-Achse des Beschleunigungssensors",
    ),
    ("line_swing", "die Drehung um die Achse der Schwingung"),
    (
        "first_half",
        "{swing}: die erste Hälfte der Aufnahme liegt weiter von der Simulation als die zweite: das {more}-Fache gegen das {less}-Fache des Rauschens",
    ),
    (
        "second_half",
        "{swing}: die zweite Hälfte der Aufnahme liegt weiter von der Simulation als die erste: das {more}-Fache gegen das {less}-Fache des Rauschens",
    ),
    (
        "at_ends",
        "{swing}: beim {motion} bleibt an den Umkehrpunkten mehr übrig als in der Mitte: das {more}-Fache gegen das {less}-Fache des Rauschens",
    ),
    (
        "at_middle",
        "{swing}: beim {motion} bleibt in der Mitte mehr übrig als an den Umkehrpunkten: das {more}-Fache gegen das {less}-Fache des Rauschens",
    ),
    (
        "growth",
        "{swing}: von {from_deg}° auf {to_deg}° wächst die Periode beim {motion} um {measured} ± {u} %, nach der Simulation um {simulated} %",
    ),
    (
        "decay",
        "{swing}: beim {motion} verliert jede Schwingung {losses}",
    ),
    (
        "loss",
        "{measured} ± {u} % bei {amplitude_deg}° (simuliert {simulated} %)",
    ),
    (
        "across",
        "{swing}: quer zur Achse der Schwingung dreht sich das Telefon um {percent} % der Schwingung, am meisten bei {most_hz} Hz; eine Bewegung in einem Winkel hat nichts davon",
    ),
    (
        "clock",
        "Die Schwingungen verlangen eine um {ppm} ppm andere Uhr des Telefons: das {sigma}-Fache der angegebenen Unsicherheit",
    ),
    (
        "pulled",
        "{name}: angegeben {stated} {unit}, die Schwingungen verlangen {change} {unit}: das {sigma}-Fache der angegebenen Unsicherheit",
    ),
    (
        "saturated",
        "{swing}: Werte an der Grenze des Sensors, weggelassen ({repair})",
    ),
    (
        "longer",
        "{^what} ist {percent} % länger, als der Rest der Messung ergibt: {sigma} Standardunsicherheiten{as_if}.",
    ),
    (
        "shorter",
        "{^what} ist {percent} % kürzer, als der Rest der Messung ergibt: {sigma} Standardunsicherheiten{as_if}.",
    ),
    (
        "larger",
        "{^what} ist {percent} % größer, als der Rest der Messung ergibt: {sigma} Standardunsicherheiten{as_if}.",
    ),
    (
        "smaller",
        "{^what} ist {percent} % kleiner, als der Rest der Messung ergibt: {sigma} Standardunsicherheiten{as_if}.",
    ),
    ("period_of", "die Periode von {swing} ({motion})"),
    ("as_if_longer", ", als wären ihre Leinen {mm} mm länger"),
    ("as_if_shorter", ", als wären ihre Leinen {mm} mm kürzer"),
    (
        "stated",
        "{name}{swings}: angegeben {stated}; der Rest der Messung ergibt {implied}: {sigma} Standardunsicherheiten.",
    ),
    ("of_swings", " von {swings}"),
    ("nothing_shown", "{^cause}: die Messung zeigt nichts davon."),
    ("with_figures", "{^cause}: {figures}."),
    ("figure", "{name} {figure}"),
    (
        "contradictions",
        "Es bleiben Widersprüche, die keine bekannte Ursache erklärt (χ² = {chi2} bei {dof} Freiheitsgraden).{hint}",
    ),
    (
        "without_one",
        " Ohne die Schwingung {swing}{with} wäre χ² {chi2} bei {dof} Freiheitsgraden: von {count} Schwingungen, der Reihe nach weggelassen, nimmt diese am meisten weg; das ist ein Hinweis und nicht mehr.",
    ),
    ("with_one", " und mit einer Ursache ({cause})"),
    (
        "nothing_shown_inside",
        "{cause}: die Messung zeigt nichts davon",
    ),
    ("with_figures_inside", "{cause}: {figures}"),
    (
        "periods_adequate",
        "Perioden und Maße passen innerhalb ihrer Unsicherheiten zusammen: nichts fehlt.",
    ),
    (
        "periods_explained",
        "Die Widersprüche verschwinden mit: {causes}; mit nichts anderem, was versucht wurde.",
    ),
    (
        "periods_ambiguous",
        "Die Widersprüche verschwinden mit: {causes}; diese Perioden können das nicht unterscheiden von: {others}.{hangs}",
    ),
    (
        "periods_contradiction",
        "Die Messung widerspricht sich, und keine bekannte Ursache erklärt es.",
    ),
    (
        "periods_remain",
        "Die meisten Widersprüche verschwinden mit: {causes}{instead}; es bleiben aber mehr, als der Zufall lässt.{hangs}",
    ),
    (
        "periods_instead",
        " (was diese Perioden nicht unterscheiden können von: {others})",
    ),
    (
        "periods_hang",
        " Der Trägheitsradius im Gieren hängt daran: {least} nach der einen, {most} nach einer anderen.",
    ),
    (
        "periods_alone",
        "Die Messung enthält nur Perioden: was sich innerhalb einer Schwingung zeigt (Dämpfung, Drift, ein loses Telefon), wurde nicht gesucht.",
    ),
    (
        "no_fit",
        "Den Messwerten ließ sich keine Simulation aller Schwingungen zusammen anpassen: beurteilt wurden ihre Perioden",
    ),
    (
        "turns_alone",
        "Keine Schwingung an zwei Leinen wurde mit Drehraten- und Beschleunigungssensor aufgenommen: jede wurde nur in ihrer stärksten Bewegung beurteilt, nach ihrer Drehung.",
    ),
    (
        "cause.added_mass",
        "Luft bewegt sich mit dem Rumpf mit und lässt ihn schwerer und träger erscheinen",
    ),
    (
        "cause.amplitude_added_mass",
        "je weiter der Ausschlag, desto mehr Luft bewegt sich mit: die Periode wächst mit der Amplitude",
    ),
    (
        "cause.bearing_friction",
        "trockene Reibung in den Lagern nimmt jeder Schwingung denselben Winkel, ob weit oder eng",
    ),
    ("cause.buoyancy", "die Luft trägt einen Teil des Gewichts"),
    (
        "cause.internal_motion",
        "im Rumpf bewegt sich etwas, etwa Wasser oder loses Zeug",
    ),
    (
        "cause.knock",
        "etwas stößt mitten in einer Schwingung an den Rumpf",
    ),
    (
        "cause.learned_force",
        "auf den Rumpf wirkt eine Kraft ohne Namen, die von Lage und Geschwindigkeit abhängt",
    ),
    (
        "cause.line_creep",
        "die Leinen werden unter der Last länger, erst schnell und dann immer langsamer",
    ),
    (
        "cause.line_mass",
        "die Leinen selbst wiegen etwas und schwingen mit",
    ),
    (
        "cause.line_slip",
        "eine Leine gibt mitten in einer Schwingung nach und bleibt länger",
    ),
    (
        "cause.line_stretch",
        "die Leinen dehnen sich wie Federn unter Gewicht und Schwingung",
    ),
    (
        "cause.line_torsion",
        "die Leinen wehren sich gegen das Verdrillen und machen das Gieren steifer",
    ),
    (
        "cause.linear_damping",
        "ein Widerstand im Verhältnis zur Geschwindigkeit lässt die Schwingung abklingen",
    ),
    (
        "cause.nonparallel_lines",
        "die Leinen sind nicht parallel: ihre oberen Enden liegen nicht so weit auseinander wie angegeben",
    ),
    (
        "cause.off_centre_cm",
        "der Schwerpunkt liegt nicht mitten zwischen den Leinen",
    ),
    (
        "cause.power_law_damping",
        "die Luft bremst mit einer Potenz der Geschwindigkeit, die zwischen der ersten und der zweiten liegt",
    ),
    (
        "cause.presliding_bearing",
        "die Lager haften und federn, bevor sie gleiten: kleine Schwingungen sind steifer und schneller",
    ),
    (
        "cause.quadratic_drag",
        "die Luft bremst mit dem Quadrat der Geschwindigkeit: weite Schwingungen klingen schneller ab als enge",
    ),
    (
        "cause.stated_length",
        "die Leinen sind nicht so lang, wie das Maßband sagte",
    ),
    (
        "cause.stated_spacing",
        "die Leinen liegen nicht so weit auseinander, wie das Maßband sagte",
    ),
    (
        "cause.support_compliance",
        "woran die Leinen hängen, bewegt sich mit der Schwingung",
    ),
    (
        "cause.unequal_lines",
        "eine Leine ist länger als die andere, und der Rumpf hängt schief",
    ),
    (
        "cause.wind",
        "Wind drückt auf den Rumpf, stetig oder in Böen",
    ),
    (
        "cause.bias_drift",
        "die Nullpunkte der Sensoren wandern, während das Telefon warm wird",
    ),
    (
        "cause.clock_scale",
        "die Uhr des Telefons geht vor oder nach",
    ),
    (
        "cause.coloured_noise",
        "die Nullpunkte der Sensoren wandern zufällig",
    ),
    (
        "cause.cross_axis",
        "eine Achse eines Sensors nimmt einen Teil einer anderen auf",
    ),
    (
        "cause.delay",
        "Werte sind später gestempelt, als sie genommen wurden",
    ),
    ("cause.drop_outs", "Werte fehlen"),
    ("cause.jitter", "die Zeitstempel streuen"),
    (
        "cause.low_pass",
        "die Sensoren folgen schnellen Änderungen nur zum Teil",
    ),
    (
        "cause.phone_mount_resonance",
        "die Befestigung des Telefons gibt nach und schwingt",
    ),
    ("cause.phone_slip", "das Telefon ist am Rumpf verrutscht"),
    ("cause.quantisation", "die Werte kommen in groben Stufen"),
    (
        "cause.saturation",
        "ein Wert liegt jenseits des Messbereichs",
    ),
    (
        "cause.gyro_scale",
        "der Maßstab des Drehratensensors stimmt nicht",
    ),
    (
        "cause.acc_scale",
        "der Maßstab des Beschleunigungssensors stimmt nicht",
    ),
    ("cause.white_noise", "die Sensoren rauschen"),
    ("cause.unknown", "etwas, das keine bekannte Ursache erklärt"),
    (
        "periods.stated_length",
        "die Leinen sind nicht so lang, wie das Maßband sagte, alle um gleich viel",
    ),
    (
        "periods.line_stretch",
        "die Leinen sind unter dem Gewicht länger als beim Messen, im Verhältnis zu ihrer Länge",
    ),
    (
        "periods.stated_spacing",
        "die Leinen liegen nicht so weit auseinander, wie das Maßband sagte, oben wie unten",
    ),
    (
        "periods.nonparallel_lines",
        "die Leinen sind nicht parallel: ihre oberen Enden liegen nicht so weit auseinander wie angegeben",
    ),
    (
        "periods.line_torsion",
        "die Leinen wehren sich gegen das Verdrillen und machen das Gieren steifer",
    ),
    (
        "periods.support_compliance",
        "woran die Leinen hängen, bewegt sich mit der Schwingung",
    ),
    (
        "periods.added_mass",
        "Luft bewegt sich beim Querschwingen mit dem Rumpf und lässt ihn schwerer erscheinen",
    ),
    (
        "periods.amplitude_added_mass",
        "je weiter der Ausschlag, desto mehr Luft bewegt sich mit dem Rumpf",
    ),
    (
        "periods.off_centre_cm",
        "der Schwerpunkt liegt nicht mitten zwischen den Leinen",
    ),
    (
        "periods.unequal_lines",
        "eine Leine ist länger als die andere, und der Rumpf hängt schief",
    ),
    ("periods.clock_scale", "die Uhr geht vor oder nach"),
    (
        "periods.stated_gravity",
        "die Schwerkraft ist nicht die angegebene",
    ),
    ("name.added_mass", "mitbewegte Luft"),
    (
        "name.amplitude_added_mass",
        "mitbewegte Luft, die mit dem Ausschlag wächst",
    ),
    ("name.bearing_friction", "trockene Lagerreibung"),
    ("name.buoyancy", "Auftrieb in der Luft"),
    ("name.internal_motion", "Bewegung im Rumpf"),
    ("name.knock", "Stoß"),
    ("name.learned_force", "Kraft ohne Namen"),
    ("name.line_creep", "Kriechen der Leinen"),
    ("name.line_mass", "Masse der Leinen"),
    ("name.line_slip", "nachgebende Leine"),
    ("name.line_stretch", "Dehnung der Leinen"),
    ("name.line_torsion", "Verdrillung der Leinen"),
    ("name.linear_damping", "lineare Dämpfung"),
    ("name.nonparallel_lines", "nicht parallele Leinen"),
    ("name.off_centre_cm", "Schwerpunkt außer der Mitte"),
    ("name.power_law_damping", "Dämpfung nach einem Potenzgesetz"),
    ("name.presliding_bearing", "federnde Lager"),
    ("name.quadratic_drag", "quadratischer Luftwiderstand"),
    ("name.stated_length", "angegebene Leinenlänge"),
    ("name.stated_spacing", "angegebener Leinenabstand"),
    ("name.stated_gravity", "angegebene Schwerkraft"),
    ("name.support_compliance", "nachgiebige Aufhängung"),
    ("name.unequal_lines", "ungleiche Leinen"),
    ("name.wind", "Wind"),
    ("name.bias_drift", "wandernder Nullpunkt"),
    ("name.clock_scale", "Gang der Uhr"),
    ("name.coloured_noise", "farbiges Rauschen"),
    ("name.cross_axis", "Übersprechen der Achsen"),
    ("name.delay", "Verzögerung"),
    ("name.drop_outs", "Aussetzer"),
    ("name.jitter", "streuende Zeitstempel"),
    ("name.low_pass", "Tiefpass"),
    ("name.phone_mount_resonance", "Resonanz der Befestigung"),
    ("name.phone_slip", "verrutschtes Telefon"),
    ("name.quantisation", "grobe Stufen"),
    ("name.saturation", "Übersteuerung"),
    ("name.gyro_scale", "Maßstab des Drehratensensors"),
    ("name.acc_scale", "Maßstab des Beschleunigungssensors"),
    ("name.white_noise", "Rauschen"),
    ("name.unknown", "nichts Bekanntes"),
    ("mode.yaw", "Gieren"),
    ("mode.sway", "Querschwingen"),
    ("mode.pitch_in_phase", "Stampfen im Gleichtakt"),
    ("mode.pitch_out_of_phase", "Stampfen im Gegentakt"),
    ("mode.roll_in_phase", "Rollen im Gleichtakt"),
    ("mode.roll_out_of_phase", "Rollen im Gegentakt"),
    (
        "mode.compound_pendulum",
        "Schwingen als physikalisches Pendel",
    ),
    ("mode.unnamed_motion", "unbenannten Schwingen"),
    ("parameter.line_length", "Leinenlänge"),
    ("parameter.spacing", "Abstand der Leinen"),
    ("parameter.top_spacing", "Abstand der Leinen oben"),
    ("parameter.axis_height", "Höhe der Achse"),
    ("parameter.gravity", "Schwerkraft"),
    ("parameter.hull_pitch", "Längsneigung des Rumpfs"),
    ("number.excess", "Überschuss"),
    ("number.force_per_strain", "Kraft je Dehnung"),
    ("number.stiffness", "Steifigkeit"),
    ("number.stiffness_along", "Steifigkeit längs"),
    ("number.stiffness_across", "Steifigkeit quer"),
    ("number.sway", "Querschwingen"),
    ("number.yaw", "Gieren"),
    ("number.along", "längs"),
    ("number.difference", "Unterschied"),
    ("number.error", "Fehler"),
];
