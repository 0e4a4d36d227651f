### Advice of the online estimator while the hull swings.

live-sensor_silent = The { $sensor } has given no samples since { $since_s } s: stop and start the recording again.
live-sensor_absent = The { $sensor } gives no samples: stop and start the recording again.
live-phone_moved = The phone moved at { $at_s } s and now sits { $tilt_deg }° another way: tape it on and start again.
live-touched = Something touched the hull at { $at_s } s: let it swing freely, or release it again.
live-saturated = { $samples } samples of the { $sensor } stand at its limit: release with a smaller amplitude.
live-gaps = The { $sensor } has { $gaps } gaps, the longest of { $longest_s } s: close other apps and keep the screen on.
live-amplitude_low = The amplitude is { $amplitude_deg }°, below 2°: stop, or release again.
live-sway = Sway (period { $period_s } s) is { $percent } % of the main motion: steady the hull and release it again.
live-other_turn = A turn about another axis (period { $period_s } s) is { $percent } % of the main motion: steady the hull and release it again.
live-same_turn = A second motion (period { $period_s } s) is { $percent } % of the main one: steady the hull and release it again.
live-out_of_reach = The swing will die down before the period is as certain as wanted: release it again.
live-long_enough = The recording is long enough: stop when you like.
