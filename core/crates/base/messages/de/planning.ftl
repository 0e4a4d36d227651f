### Warnungen eines Plans.

plan-yaw_near_in_phase = Schwingung { $swing }: Gieren ({ $yaw_period_s } s) und das gleichphasige Pendeln ({ $in_phase_period_s } s) liegen { $apart_percent } % auseinander und regen einander an (Kane und Tseng): Gieren und Querschwingen einzeln anregen, oder Leinenlänge oder Abstand ändern.
plan-no_beat = Schwingung { $swing }: ein Abstand von { $spacing_m } m liegt so nahe am doppelten Gierträgheitsradius ({ $twice_k_yaw_m } m), dass Gieren und Querschwingen in { $duration_s } s keine Schwebung zeigen: hier keine Schwebungen zählen.
plan-slack_line = Schwingung { $swing }: bei { $amplitude_deg }° Auslenkung wird nach { $t_s } s eine Leine lose: weniger auslenken (schräg längs der Aufhängung allein müssen die Leinen unter { $most_lean_deg }° bleiben).
plan-tilt_needed = Schwingung { $swing } hängt geneigt, { $tilt_deg }° (Bug nach oben positiv): die Punkte um { $points_moved_m } m längs des Decks versetzen (nach vorn positiv; die Ecken des Rahmens gäben { $corner_tilt_deg }°) und die Neigung am Telefon ablesen.
plan-spacing_too_short = { $quantity } erreicht u = { $reached_percent } %, nicht { $wanted_percent } %: der Abstand von { $spacing_m } m, auf { $u_input_mm } mm bekannt, begrenzt es. Auf { $u_input_needed_mm } mm messen; mit diesem Maßband müssten die Punkte { $spacing_needed_m } m auseinander liegen.
plan-not_reached = { $quantity } erreicht u = { $reached_u }, nicht { $wanted_u }: das meiste kommt von: { $input } ({ $contribution_u }). Dieser Wert müsste { $times_better }-mal genauer bekannt sein.
plan-not_determined = { $quantity } wird von diesen Schwingungen nicht bestimmt.
plan-rough_hull = { $quantity } des Rumpfs ist nur auf { $u_percent } % bekannt, und was daraus vorhergesagt wird, nicht besser: mit der Sitzung der ersten Schwingung neu planen.
plan-hang_fore_and_aft = Waagerecht, zwei Leinen von { $length_m } m, { $spacing_m } m auseinander, hintereinander in der Mittschiffsebene (H-D)
plan-hang_level = Waagerecht, zwei Leinen von { $length_m } m, { $spacing_m } m auseinander, nebeneinander über dem Schwerpunkt (B-F)
plan-hang_bow_up = Zwei Leinen von { $length_m } m, { $spacing_m } m auseinander, nebeneinander, { $moved_m } m weiter vorn als waagerecht (Richtung { $points }): der Bug hängt { $tilt_deg }° hoch
plan-hang_bow_down = Zwei Leinen von { $length_m } m, { $spacing_m } m auseinander, nebeneinander, { $moved_m } m weiter achtern als waagerecht (Richtung { $points }): der Bug hängt { $tilt_deg }° tief
