### Sentences, quantities, closed-form estimators, inputs and motions of a measurement.

inertia-route-yaw_period = yaw period with line length and spacing
inertia-route-period_ratio = yaw period over sway period, times half the spacing
inertia-route-beat_count = oscillations per beat of yaw and sway
inertia-route-double_pendulum = both periods of the double pendulum, sway period as clock
inertia-route-double_pendulum_and_line_length = both periods of the double pendulum, with the line length
inertia-route-compound = compound pendulum
inertia-route-compound_pendulum = compound pendulum
inertia-route-lamboley = compound pendulum at two heights (Lamboley)
inertia-route-incline = inclining by a weight
inertia-route-tilted_yaw = yaw level and at two tilts
inertia-route-tilted_yaw_right_angle = yaw level and at two tilts a right angle apart
inertia-route-one_tilt = roll, yaw and one tilted yaw
inertia-route-tilt_fit = yaw at all tilts by least squares
inertia-route-points_moved = moving the suspension points and the tilt that follows
inertia-route-incline_both_ends = inclining at bow and stern
inertia-route-joint_estimate = joint estimate from everything in the session

inertia-quantity-k_yaw_m = Yaw gyradius
inertia-quantity-k_pitch_m = Pitch gyradius
inertia-quantity-k_roll_m = Roll gyradius
inertia-quantity-cm_depth_m = Depth of the centre of mass
inertia-quantity-psi_deg = Tilt of the principal axis

inertia-stated = { $name } is stated as { $stated }; by { $by } it is { $implied }: { $verdict } ({ $sigma } standard uncertainties).
inertia-by_sway = the sway period of { $swing }
inertia-by_all = all swings together ({ $inputs })
inertia-against = { $quantity }: the { $one } ({ $one_from }) gives { $first }, the { $other } ({ $other_from }) gives { $second }: { $verdict } ({ $sigma } standard uncertainties of the difference).{ $pairs }
inertia-pairs = {" "}The same two ways differ by { $least } to { $most } over { $count } pairs of swings.
inertia-agree = they agree
inertia-contradict = they contradict each other
inertia-no_gravity = neither gravity nor latitude is stated: standard gravity with u = 0.015 m/s² is used
inertia-no_joint_estimate = no joint estimate: { $reason }
inertia-widened = the session contradicts itself (χ² = { $chi2 } with { $dof } degrees of freedom): all uncertainties are widened by { $factor }
inertia-no_verdict = no verdict on { $quantity }: { $reason }
inertia-no_verdict_undetermined = no verdict on { $quantity }: the swings do not determine it
inertia-no_single_period = the entry at { $at_s } s ({ $period_s } s) is no single period of this motion: left out
inertia-bare_recording = a bare recording gives modes alone; a session with dimensions gives inertia
inertia-yaw_by_word = no accelerometer that sees gravity: the vertical is unknown, so the strongest mode is called yaw on the operator's word alone
inertia-no_shapes = no accelerometer that sees gravity: the vertical is unknown, so the modes cannot be named by shape
inertia-track_alone = a displacement alone does not show shapes: modes are named by their periods
inertia-not_seen = { $motion } was meant to be excited but does not show in the data
inertia-not_meant = the strongest motion is { $motion }, which was not meant to be excited
inertia-parasitic = parasitic { $motion } at { $percent } % of the strongest motion
inertia-of = { $what } of { $which }
inertia-an_id = { $id }

inertia-input-gravity = gravity
inertia-input-phone_clock = phone clock
inertia-input-mass = mass
inertia-input-gyradius = gyradius
inertia-input-product_xz = product xz
inertia-input-depth = depth
inertia-input-line_length = line length
inertia-input-spacing = spacing
inertia-input-top_spacing = top spacing
inertia-input-axis_height = axis height
inertia-input-hull_pitch = hull pitch
inertia-input-suspension_points = suspension points
inertia-input-incline_bow = incline bow
inertia-input-incline_stern = incline stern
inertia-input-samples = samples
inertia-input-finite-amplitude_correction = finite-amplitude correction
inertia-input-unknown_tilt_of_the_principal_axes = unknown tilt of the principal axes
inertia-input-yaw_period = yaw period
inertia-input-sway_period = sway period
inertia-input-pitch_in_phase_period = pitch in phase period
inertia-input-pitch_out_of_phase_period = pitch out of phase period
inertia-input-roll_in_phase_period = roll in phase period
inertia-input-roll_out_of_phase_period = roll out of phase period
inertia-input-compound_pendulum_period = compound pendulum period
inertia-input-unnamed_motion_period = unnamed motion period

inertia-motion-yaw = yaw
inertia-motion-sway = sway
inertia-motion-surge = surge
inertia-motion-pitch = pitch
inertia-motion-roll = roll
inertia-motion-pitch_in_phase = pitch in phase
inertia-motion-pitch_out_of_phase = pitch out of phase
inertia-motion-roll_in_phase = roll in phase
inertia-motion-roll_out_of_phase = roll out of phase
inertia-motion-compound_pendulum = compound pendulum
inertia-motion-unnamed_motion = unnamed motion
