//! Sentences by key, in German: the same keys as in English.

/// Sentences by key; `{name}` stands for an argument.
pub const GERMAN: [(&str, &str); 85] = [
    (
        "start",
        "{title} vermessen: {steps} Schritte, etwa {minutes} Minuten Aufnahme. Das Telefon so am Rumpf festkleben, dass es nicht rutschen kann, und bis zum Ende nicht bewegen. Dann beginnen.",
    ),
    (
        "level_flat",
        "Den Rumpf waagerecht hängen: Bug {bow_up_deg}° nach oben, Steuerbord {starboard_down_deg}° nach unten. Annehmen, wenn beides nahe 0 ist und er ruhig hängt.",
    ),
    (
        "level_reference",
        "Den Rumpf mit einer Wasserwaage waagerecht hängen und sagen, wann er es ist: von da an zählen die Neigungen. Jetzt sind es {angle_deg}° von dort. Annehmen, wenn er waagerecht und ruhig hängt.",
    ),
    (
        "level_nothing",
        "Den Rumpf mit einer Wasserwaage waagerecht hängen und sagen, wann er es ist: das Telefon allein kann es nicht wissen, denn niemand hat gesagt, wie es liegt.",
    ),
    (
        "level_no_gravity",
        "Den Rumpf waagerecht hängen. Der Beschleunigungssensor zeigt noch keine Schwerkraft.",
    ),
    (
        "rest",
        "Den Rumpf hängen lassen, nichts berühren: {still_s} von {wanted_s} s Ruhe.",
    ),
    (
        "rest_moving",
        "Der Rumpf bewegt sich, mit {rate_deg_s} °/s und {tilt_deg}° Neigung: mit den Händen beruhigen, langsam loslassen. Die Ruhe zählt ab dann.",
    ),
    (
        "rest_found",
        "Die Ruhe ist aufgenommen: Drehratensensor {gyroscope_hz} Hz, Rauschen {noise_mrad_s} mrad/s, Nullpunkt {bias_mrad_s} mrad/s. Annehmen.",
    ),
    (
        "hang",
        "Schritt {id}: den Rumpf an Leinen von {line_length_m} m hängen, {spacing_m} m auseinander, {orientation}, {extras}. Dann Länge und Abstand von Knoten zu Knoten messen und eingeben.",
    ),
    (
        "hang_compound",
        "Schritt {id}: den Rumpf in zwei umgekehrte V hängen, die Achse {axis_height_m} m über den Punkten, {orientation}, {extras}. Dann diese Höhe messen und eingeben.",
    ),
    (
        "hang_incline",
        "Schritt {id}: {mass_kg} kg am {end} aufhängen, {arm_m} m von den Aufhängepunkten und {depth_m} m darunter. Alle drei messen und eingeben.",
    ),
    ("no_extras", "waagerecht, nichts hinzugefügt"),
    ("extra_bow_up", "den Bug {pitch_deg}° nach oben"),
    ("extra_bow_down", "den Bug {pitch_deg}° nach unten"),
    (
        "extra_points_forward",
        "die Punkte nach vorn versetzt, bis er so hängt, um etwa {points_m} m: messen, wie weit",
    ),
    (
        "extra_points_aft",
        "die Punkte nach achtern versetzt, bis er so hängt, um etwa {points_m} m: messen, wie weit",
    ),
    ("extra_masses", "{count} Zusatzmassen befestigt"),
    (
        "ready",
        "Den Rumpf für {excited} auslenken und halten: {amplitude_deg}°. Aufnahme starten, 3 s warten, ohne Stoß loslassen und zurücktreten. Sie dauert {duration_s} s und endet von selbst.",
    ),
    (
        "ready_incline",
        "Den Rumpf mit dem Gewicht zur Ruhe kommen lassen. Aufnahme starten und zurücktreten; sie endet von selbst nach {wanted_s} s Ruhe.",
    ),
    ("waiting", "Ohne Stoß loslassen und zurücktreten."),
    ("swinging", "Nichts berühren: noch {left_s} s."),
    ("still", "Nichts berühren: {still_s} von {wanted_s} s Ruhe."),
    (
        "interrupted",
        "Die Aufnahme von {id} wurde nach {recorded_s} s unterbrochen. Fortsetzen, wenn der Rumpf die ganze Zeit frei geschwungen ist; behalten, was aufgenommen ist; oder wiederholen.",
    ),
    (
        "interrupted_ended",
        "Die Aufnahme von {id} war nach {recorded_s} s gerade zu Ende, als die App anhielt. Behalten oder wiederholen.",
    ),
    (
        "interrupted_restarted",
        "Die Aufnahme von {id} wurde nach {recorded_s} s unterbrochen, und das Telefon war inzwischen ausgeschaltet: sie \
         kann nicht weitergehen. Behalten, was aufgenommen ist, oder wiederholen.",
    ),
    (
        "interrupted_empty",
        "Die Aufnahme von {id} wurde unterbrochen, bevor etwas aufgenommen war. Wiederholen.",
    ),
    ("judge_accept", "{id} ist gut: annehmen."),
    (
        "judge_repeat",
        "{id} sollte wiederholt werden. Wiederholen oder trotzdem annehmen.",
    ),
    (
        "measure",
        "Alle Schritte sind getan. Die Sitzung wird geschrieben und ausgewertet.",
    ),
    (
        "failed",
        "Kein Ergebnis: {reason}. Einen Schritt wieder öffnen und wiederholen, oder noch einmal versuchen.",
    ),
    (
        "critique",
        "Das Ergebnis ist da. Nun wird gesucht, was die Simulation falsch macht; das dauert Minuten und kann ausgelassen werden.",
    ),
    (
        "suggest",
        "Eine weitere Schwingung würde {count} Ursachen unterscheiden, die diese Schwingungen nicht trennen: Leinen von {line_length_m} m, {spacing_m} m auseinander, {extras}; {excited} mit {amplitude_deg}° für {duration_s} s. Ausführen oder lassen.",
    ),
    (
        "suggest_compound",
        "Eine weitere Schwingung würde {count} Ursachen unterscheiden, die diese Schwingungen nicht trennen: die Achse {axis_height_m} m über den Punkten, {extras}; {excited} mit {amplitude_deg}° für {duration_s} s. Ausführen oder lassen.",
    ),
    ("done", "Fertig. Die Sitzung liegt in {session}."),
    (
        "reason_no_swing",
        "keine freie Schwingung von vier Perioden wurde darin gefunden",
    ),
    (
        "reason_slip",
        "das Telefon hat sich bei {at_s} s am Rumpf bewegt, um {tilt_deg}°: neu festkleben",
    ),
    ("reason_slip_seen", "das Telefon wurde rutschen gesehen"),
    (
        "reason_touched",
        "die Schwingung wurde bei {at_s} s gestört, und der Teil davor ist zu kurz, um das aufzuwiegen",
    ),
    (
        "reason_sway",
        "{kind} mit {percent} % der Hauptbewegung (Periode {period_s} s) wurde ungewollt angestoßen: sanfter loslassen",
    ),
    (
        "reason_period",
        "das Rauschen lässt die Periode auf {u_ppm} ppm unsicher, gewünscht sind {wanted_ppm} ppm: länger schwingen lassen oder weiter auslenken",
    ),
    (
        "reason_small",
        "bei {released_deg}° statt {wanted_deg}° losgelassen",
    ),
    (
        "reason_large",
        "bei {released_deg}° statt {wanted_deg}° losgelassen, wo Luftwiderstand und endlicher Ausschlag mehr ausmachen",
    ),
    (
        "reason_saturated",
        "{samples} Werte des {sensor}s liegen an seiner Grenze: weniger weit auslenken",
    ),
    (
        "reason_gaps",
        "der {sensor} hat eine Lücke von {longest_s} s",
    ),
    ("reason_silent", "der {sensor} ist verstummt"),
    (
        "reason_moving",
        "der Rumpf war nicht {wanted_s} s lang in Ruhe",
    ),
    (
        "reason_no_tilt",
        "die Neigung ist nicht zu ermitteln: es wurde keine Ruhe mit Beschleunigungssensor aufgenommen",
    ),
    (
        "reason_far",
        "der Rumpf neigte sich um {angle_deg}°, erwartet waren {expected_deg}°: Gewicht und Hebelarm prüfen",
    ),
    (
        "note_touched",
        "die Schwingung wurde bei {at_s} s gestört; was davor oder danach frei schwang, ist lang genug und wird verwendet",
    ),
    (
        "note_period",
        "das Rauschen lässt die Periode auf {u_ppm} ppm unsicher; {wanted_ppm} ppm waren erlaubt",
    ),
    (
        "note_amplitude",
        "bei {released_deg}° losgelassen, {left_deg}° am Ende",
    ),
    ("note_tilt", "das Gewicht neigt den Rumpf um {angle_deg}°"),
    (
        "note_gaps",
        "der {sensor} hat {gaps} Lücken, die längste von {longest_s} s",
    ),
    (
        "note_interrupted",
        "die Aufnahme wurde unterbrochen und ging weiter",
    ),
    (
        "advice_small",
        "Er schwingt mit {amplitude_deg}° statt {wanted_deg}°: anhalten und weiter auslenken.",
    ),
    (
        "advice_large",
        "Er schwingt mit {amplitude_deg}° statt {wanted_deg}°: anhalten und weniger weit auslenken.",
    ),
    (
        "advice_moving",
        "Der Rumpf bewegt sich noch: warten oder langsam beruhigen.",
    ),
    (
        "warn_silent",
        "Seit {silent_s} s kommen keine Werte: die App auf dem Bildschirm lassen.",
    ),
    (
        "warn_sensor_stopped",
        "Das System des Telefons hat den {sensor} angehalten.",
    ),
    (
        "warn_disk",
        "Der Speicher ist voll. Was bisher aufgenommen ist, bleibt erhalten: Platz schaffen, dann weitermachen, behalten, was da ist, oder wiederholen.",
    ),
    (
        "warn_unwritable",
        "Die Aufnahme kann nicht geschrieben werden: {reason}",
    ),
    (
        "warn_journal_cut",
        "Die letzten {bytes} Bytes des Protokolls waren unvollständig und wurden abgeschnitten: die letzte Entscheidung wird noch einmal erfragt.",
    ),
    (
        "warn_unused",
        "{files} Aufnahmen im Ordner gehören zu keinem Schritt; sie bleiben erhalten.",
    ),
    (
        "warn_no_rest",
        "Es wurde keine Ruhe aufgenommen: Nullpunkt, Rauschen und Raten sind vorher nicht bekannt.",
    ),
    ("warn_critique", "Es gibt keine Kritik: {reason}"),
    ("yaw", "Gieren"),
    ("sway", "Querschwingen"),
    ("surge", "Längsschwingen"),
    ("pitch", "Stampfen"),
    ("roll", "Rollen"),
    ("turn", "eine andere Drehung"),
    ("bow", "Bug"),
    ("stern", "Heck"),
    ("incline", "Neigungsversuch"),
    ("extra", "Zusatz"),
    ("up", "hoch"),
    ("down", "tief"),
    ("athwartships", "querschiffs"),
    ("fore_and_aft", "längsschiffs"),
    ("gyroscope", "Drehratensensor"),
    ("accelerometer", "Beschleunigungssensor"),
    (
        "gravity-free_accelerometer",
        "schwerkraftfreie Beschleunigungssensor",
    ),
    ("rangefinder", "Entfernungsmesser"),
    ("timer", "Zeitgeber"),
    (
        "reason_lines_unknown",
        "Leinenlänge und Abstand sind nicht bekannt",
    ),
];
