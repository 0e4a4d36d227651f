package org.gyradius.app.ui

import java.math.BigDecimal
import java.math.MathContext
import java.math.RoundingMode
import java.text.DecimalFormatSymbols
import java.util.Locale

/** A figure and its uncertainty as text, the uncertainty with two digits and the figure as many places: layout only. */
fun withUncertainty(value: Double, u: Double): Pair<String, String> {
    if (!u.isFinite() || u <= 0.0) return plain(value, 4) to "–"
    val rounded = BigDecimal(u).let { it.setScale(2 - (it.precision() - it.scale()), RoundingMode.HALF_UP) }
    val places = rounded.scale().coerceAtLeast(0)
    return plain(value, places) to plain(u, places)
}

/** With a minus sign as long as a plus, as the library writes it. */
private fun plain(value: Double, places: Int): String = String.format(Locale.getDefault(), "%.${places}f", value).replace('-', '−')

/** A figure as it stands in a field before anybody types: six digits, no exponent. */
internal fun asTyped(value: Double): String =
    withDecimalSign(BigDecimal(value).round(MathContext(6)).stripTrailingZeros().toPlainString())

/** A figure that is written with a decimal point, as the language of the screen writes it. */
internal fun withDecimalSign(written: String): String =
    written.replace('.', DecimalFormatSymbols.getInstance(Locale.getDefault()).decimalSeparator)
