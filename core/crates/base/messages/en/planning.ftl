### Warnings of a plan.

plan-yaw_near_in_phase = Swing { $swing }: yaw ({ $yaw_period_s } s) and the in-phase pendulum mode ({ $in_phase_period_s } s) are { $apart_percent } % apart and will feed each other (Kane and Tseng): excite yaw and sway one at a time, or change the line length or the spacing.
plan-no_beat = Swing { $swing }: a spacing of { $spacing_m } m is so near to twice the yaw gyradius ({ $twice_k_yaw_m } m) that yaw and sway do not beat within { $duration_s } s: count no beats here.
plan-slack_line = Swing { $swing }: released at { $amplitude_deg }°, a line goes slack after { $t_s } s: release it with less (leaning along the suspension alone, the lines must stay below { $most_lean_deg }°).
plan-tilt_needed = Swing { $swing } hangs tilted, { $tilt_deg }° (bow up positive): move the points { $points_moved_m } m along the deck (forward positive; the frame's corners would give { $corner_tilt_deg }°), and read the tilt from the phone.
plan-spacing_too_short = { $quantity } reaches u = { $reached_percent } %, not { $wanted_percent } %: a spacing of { $spacing_m } m known to { $u_input_mm } mm is what limits it. Measure it to { $u_input_needed_mm } mm; with this tape the points would have to be { $spacing_needed_m } m apart.
plan-not_reached = { $quantity } reaches u = { $reached_u }, not { $wanted_u }: most of it comes from { $input } ({ $contribution_u }), which would have to be known { $times_better } times better.
plan-not_determined = { $quantity } is not determined by these swings.
plan-rough_hull = { $quantity } of the hull is known to { $u_percent } % only, and what is predicted from it no better: plan again with the first swing's session.
plan-hang_fore_and_aft = level, two lines of { $length_m } m, { $spacing_m } m apart, one behind the other in the centre plane (H-D)
plan-hang_level = level, two lines of { $length_m } m, { $spacing_m } m apart, side by side over the centre of mass (B-F)
plan-hang_bow_up = two lines of { $length_m } m, { $spacing_m } m apart, side by side, { $moved_m } m forward of the level ones (towards { $points }): the bow hangs { $tilt_deg }° up
plan-hang_bow_down = two lines of { $length_m } m, { $spacing_m } m apart, side by side, { $moved_m } m aft of the level ones (towards { $points }): the bow hangs { $tilt_deg }° down
