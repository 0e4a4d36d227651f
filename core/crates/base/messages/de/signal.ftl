### Was beim Zerlegen einer Aufnahme auffällt.

signal-misfit = Der Rest ist das { $times }-Fache des weißen Rauschens: farbiges Rauschen oder Bewegung, die das Modell nicht enthält; die Standardunsicherheiten sind dafür erweitert
signal-growing = { $count } der Schwingungsformen würden anwachsen, was eine freie Schwingung nicht tut: ihr Abklingen ist auf null gesetzt
signal-many = Es wurden so viele Schwingungsformen gefunden wie erlaubt; es kann mehr geben
signal-lead_in = Die ersten { $length_s } s (Warten, Handhaben, Loslassen) sind weggelassen
signal-lead_out = Die letzten { $length_s } s, von { $from_s } s an, sind weggelassen: die Schwingung wurde gestört
signal-second_swing = Eine weitere Schwingung zwischen { $from_s } s und { $to_s } s ist weggelassen (der Rumpf wurde berührt oder neu losgelassen)
