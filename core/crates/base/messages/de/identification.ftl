### Sätze, Größen, geschlossene Schätzer, Eingaben und Bewegungen einer Messung.

inertia-route-yaw_period = Gierperiode mit Leinenlänge und Abstand
inertia-route-period_ratio = Gierperiode durch Querperiode, mal dem halben Abstand
inertia-route-beat_count = Schwingungen je Schwebung von Gieren und Querschwingen
inertia-route-double_pendulum = beide Perioden des Doppelpendels, Querperiode als Uhr
inertia-route-double_pendulum_and_line_length = beide Perioden des Doppelpendels, mit der Leinenlänge
inertia-route-compound = physikalisches Pendel
inertia-route-compound_pendulum = physikalisches Pendel
inertia-route-lamboley = physikalisches Pendel in zwei Höhen (Lamboley)
inertia-route-incline = Neigen mit einem Gewicht
inertia-route-tilted_yaw = Gieren waagerecht und bei zwei Neigungen
inertia-route-tilted_yaw_right_angle = Gieren waagerecht und bei zwei Neigungen im rechten Winkel
inertia-route-one_tilt = Rollen, Gieren und ein geneigtes Gieren
inertia-route-tilt_fit = Gieren bei allen Neigungen, nach kleinsten Quadraten
inertia-route-points_moved = Verschieben der Aufhängepunkte und die Neigung, die folgt
inertia-route-incline_both_ends = Neigen an Bug und Heck
inertia-route-joint_estimate = gemeinsame Schätzung aus der ganzen Messung

inertia-quantity-k_yaw_m = Trägheitsradius Gieren
inertia-quantity-k_pitch_m = Trägheitsradius Stampfen
inertia-quantity-k_roll_m = Trägheitsradius Rollen
inertia-quantity-cm_depth_m = Tiefe des Schwerpunkts
inertia-quantity-psi_deg = Neigung der Hauptachse

inertia-stated = { $name }: angegeben { $stated }; nach { $by } sind es { $implied }: { $verdict } ({ $sigma } Standardunsicherheiten).
inertia-by_sway = der Querperiode von { $swing }
inertia-by_all = allen Schwingungen zusammen ({ $inputs })
inertia-against = { $quantity }: { $first } ({ $one }; { $one_from }) gegen { $second } ({ $other }; { $other_from }): { $verdict } ({ $sigma } Standardunsicherheiten der Differenz).{ $pairs }
inertia-pairs = {" "}Dieselben zwei Wege liegen bei { $count } Paaren von Schwingungen um { $least } bis { $most } auseinander.
inertia-agree = beides stimmt überein
inertia-contradict = beides widerspricht sich
inertia-no_gravity = Weder Schwerkraft noch Breitengrad sind angegeben: es gilt die Normalfallbeschleunigung mit u = 0,015 m/s²
inertia-no_joint_estimate = Keine gemeinsame Schätzung: { $reason }
inertia-widened = Die Messung widerspricht sich (χ² = { $chi2 } bei { $dof } Freiheitsgraden): alle Unsicherheiten sind auf das { $factor }-Fache erweitert
inertia-no_verdict = Kein Urteil über { $quantity }: { $reason }
inertia-no_verdict_undetermined = Kein Urteil über { $quantity }: die Schwingungen bestimmen es nicht
inertia-no_single_period = Der Eintrag bei { $at_s } s ({ $period_s } s) ist keine einzelne Periode dieser Bewegung: weggelassen
inertia-bare_recording = Eine Aufnahme allein ergibt nur Schwingungsformen und Perioden; erst eine Messung mit Maßen ergibt Trägheitsradien
inertia-yaw_by_word = Kein Beschleunigungssensor, der die Schwerkraft sieht: die Senkrechte ist unbekannt, und die stärkste Schwingung heißt nur auf das Wort des Bedieners hin Gieren
inertia-no_shapes = Kein Beschleunigungssensor, der die Schwerkraft sieht: die Senkrechte ist unbekannt, und die Schwingungen lassen sich nicht nach ihrer Form benennen
inertia-track_alone = Ein Weg allein zeigt keine Formen: die Schwingungen sind nach ihren Perioden benannt
inertia-not_seen = { $motion } sollte angeregt werden, zeigt sich aber nicht in den Daten
inertia-not_meant = Die stärkste Bewegung ist { $motion }, das nicht angeregt werden sollte
inertia-parasitic = Ungewollt: { $motion } mit { $percent } % der stärksten Bewegung
inertia-of = { $what } von { $which }
inertia-an_id = { $id }

inertia-input-gravity = Schwerkraft
inertia-input-phone_clock = Uhr des Telefons
inertia-input-mass = Masse
inertia-input-gyradius = Trägheitsradius
inertia-input-product_xz = Deviationsmoment
inertia-input-depth = Schwerpunkttiefe
inertia-input-line_length = Leinenlänge
inertia-input-spacing = Abstand der Leinen
inertia-input-top_spacing = Abstand der Leinen oben
inertia-input-axis_height = Höhe der Achse
inertia-input-hull_pitch = Längsneigung des Rumpfs
inertia-input-suspension_points = Aufhängepunkte
inertia-input-incline_bow = Neigungsversuch am Bug
inertia-input-incline_stern = Neigungsversuch am Heck
inertia-input-samples = Messwerte
inertia-input-finite-amplitude_correction = Korrektur für endliche Amplitude
inertia-input-unknown_tilt_of_the_principal_axes = unbekannte Neigung der Hauptachsen
inertia-input-yaw_period = Gierperiode
inertia-input-sway_period = Querperiode
inertia-input-pitch_in_phase_period = Stampfperiode im Gleichtakt
inertia-input-pitch_out_of_phase_period = Stampfperiode im Gegentakt
inertia-input-roll_in_phase_period = Rollperiode im Gleichtakt
inertia-input-roll_out_of_phase_period = Rollperiode im Gegentakt
inertia-input-compound_pendulum_period = Periode als physikalisches Pendel
inertia-input-unnamed_motion_period = Periode einer unbenannten Schwingung

inertia-motion-yaw = Gieren
inertia-motion-sway = Querschwingen
inertia-motion-surge = Längsschwingen
inertia-motion-pitch = Stampfen
inertia-motion-roll = Rollen
inertia-motion-pitch_in_phase = Stampfen im Gleichtakt
inertia-motion-pitch_out_of_phase = Stampfen im Gegentakt
inertia-motion-roll_in_phase = Rollen im Gleichtakt
inertia-motion-roll_out_of_phase = Rollen im Gegentakt
inertia-motion-compound_pendulum = Schwingen als physikalisches Pendel
inertia-motion-unnamed_motion = unbenanntes Schwingen
