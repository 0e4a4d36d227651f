### Hinweise des mitlaufenden Schätzers, während der Rumpf schwingt.

live-sensor_silent = Der { $sensor } liefert seit { $since_s } s keine Werte mehr: Aufnahme beenden und neu beginnen.
live-sensor_absent = Der { $sensor } liefert keine Werte: Aufnahme beenden und neu beginnen.
live-phone_moved = Das Telefon hat sich bei { $at_s } s bewegt und liegt nun um { $tilt_deg }° anders: festkleben und neu beginnen.
live-touched = Bei { $at_s } s hat etwas den Rumpf berührt: frei schwingen lassen oder neu auslenken.
live-saturated = { $samples } Werte des { $sensor }s liegen an seiner Grenze: mit kleinerem Ausschlag loslassen.
live-gaps = Der { $sensor } hat { $gaps } Lücken, die längste von { $longest_s } s: andere Apps schließen und den Bildschirm anlassen.
live-amplitude_low = Der Ausschlag ist { $amplitude_deg }°, unter 2°: beenden oder neu auslenken.
live-sway = Querschwingen (Periode { $period_s } s) mit { $percent } % der Hauptbewegung: Rumpf beruhigen und neu auslenken.
live-other_turn = Drehung um eine andere Achse (Periode { $period_s } s) mit { $percent } % der Hauptbewegung: Rumpf beruhigen und neu auslenken.
live-same_turn = Eine zweite Bewegung (Periode { $period_s } s) mit { $percent } % der Hauptbewegung: Rumpf beruhigen und neu auslenken.
live-out_of_reach = Die Schwingung klingt ab, bevor die Periode so sicher ist wie gewünscht: neu auslenken.
live-long_enough = Die Aufnahme ist lang genug: beenden, wann Sie wollen.
