### What is noticed while a record is decomposed.

signal-misfit = the residual is { $times } times the white noise: coloured noise or motion that the model does not hold; the standard errors are widened for it
signal-growing = { $count } of the modes would grow, which a free swing does not: their decay is held at zero
signal-many = as many modes as allowed were found; there may be more
signal-lead_in = the first { $length_s } s (waiting, handling, release) are left out
signal-lead_out = the last { $length_s } s, from { $from_s } s on, are left out: the swing was disturbed
signal-second_swing = another swing between { $from_s } s and { $to_s } s (the hull was touched or released again) is left out
