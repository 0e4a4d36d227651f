package org.gyradius.app.ui

import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Surface
import androidx.compose.material3.darkColorScheme
import androidx.compose.material3.lightColorScheme
import androidx.compose.runtime.Composable
import androidx.compose.ui.graphics.Color

private val Light = lightColorScheme(
    primary = Color(0xFF0B5C7D),
    onPrimary = Color.White,
    primaryContainer = Color(0xFFC3E8FA),
    onPrimaryContainer = Color(0xFF001F2B),
    background = Color.White,
    surface = Color.White,
    onSurface = Color(0xFF101416),
)

private val Dark = darkColorScheme(
    primary = Color(0xFF86D0F2),
    onPrimary = Color(0xFF003548),
    primaryContainer = Color(0xFF004D66),
    onPrimaryContainer = Color(0xFFC3E8FA),
    background = Color(0xFF0B0F11),
    surface = Color(0xFF0B0F11),
    onSurface = Color(0xFFE4E9EB),
)

/** Colours of high contrast: it is read in the sun, at arm's length. */
@Composable
fun GyradiusTheme(content: @Composable () -> Unit) {
    MaterialTheme(colorScheme = if (isSystemInDarkTheme()) Dark else Light) { Surface(content = content) }
}
