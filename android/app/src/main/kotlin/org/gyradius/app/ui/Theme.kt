package org.gyradius.app.ui

import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Surface
import androidx.compose.material3.darkColorScheme
import androidx.compose.material3.lightColorScheme
import androidx.compose.runtime.Composable
import androidx.compose.ui.graphics.Color

private val Light = lightColorScheme(
    primary = Color(0xFF00506F),
    onPrimary = Color.White,
    primaryContainer = Color(0xFFC3E8FA),
    onPrimaryContainer = Color(0xFF001F2B),
    secondary = Color(0xFF3E5560),
    onSecondary = Color.White,
    secondaryContainer = Color(0xFFD9E7EE),
    onSecondaryContainer = Color(0xFF0C1D25),
    tertiary = Color(0xFF8A4B00),
    onTertiary = Color.White,
    tertiaryContainer = Color(0xFFFFDDB5),
    onTertiaryContainer = Color(0xFF2B1700),
    error = Color(0xFFB3101C),
    onError = Color.White,
    errorContainer = Color(0xFFFFDAD6),
    onErrorContainer = Color(0xFF410004),
    background = Color.White,
    onBackground = Color(0xFF101416),
    surface = Color.White,
    onSurface = Color(0xFF101416),
    surfaceVariant = Color(0xFFE4EBEE),
    onSurfaceVariant = Color(0xFF333D42),
    surfaceContainer = Color(0xFFEFF4F6),
    surfaceContainerHigh = Color(0xFFECF2F4),
    surfaceContainerHighest = Color(0xFFE9EFF2),
    outline = Color(0xFF5B676D),
    outlineVariant = Color(0xFFB4C0C6),
)

private val Dark = darkColorScheme(
    primary = Color(0xFF8FD6F7),
    onPrimary = Color(0xFF003548),
    primaryContainer = Color(0xFF004D66),
    onPrimaryContainer = Color(0xFFC3E8FA),
    secondary = Color(0xFFB5CAD5),
    onSecondary = Color(0xFF20333C),
    secondaryContainer = Color(0xFF2B3B44),
    onSecondaryContainer = Color(0xFFD9E7EE),
    tertiary = Color(0xFFFFB95C),
    onTertiary = Color(0xFF492900),
    tertiaryContainer = Color(0xFF5C3700),
    onTertiaryContainer = Color(0xFFFFDDB5),
    error = Color(0xFFFFB4AB),
    onError = Color(0xFF690009),
    errorContainer = Color(0xFF7E0711),
    onErrorContainer = Color(0xFFFFDAD6),
    background = Color(0xFF0B0F11),
    onBackground = Color(0xFFE9EEF0),
    surface = Color(0xFF0B0F11),
    onSurface = Color(0xFFE9EEF0),
    surfaceVariant = Color(0xFF2A3337),
    onSurfaceVariant = Color(0xFFC6D0D5),
    surfaceContainer = Color(0xFF182024),
    surfaceContainerHigh = Color(0xFF1D262A),
    surfaceContainerHighest = Color(0xFF222B30),
    outline = Color(0xFF94A1A8),
    outlineVariant = Color(0xFF414C52),
)

/** Colours of high contrast: it is read in the sun, at arm's length. */
@Composable
fun GyradiusTheme(content: @Composable () -> Unit) {
    MaterialTheme(colorScheme = if (isSystemInDarkTheme()) Dark else Light) { Surface(content = content) }
}
