package org.gyradius.app.cues

import android.content.Context
import android.media.AudioManager
import android.media.ToneGenerator
import android.os.VibrationEffect
import android.os.Vibrator
import android.speech.tts.TextToSpeech
import androidx.annotation.StringRes
import java.util.Locale
import org.gyradius.app.R

/** The phone's own tones, voice and vibration. Whatever of them a phone does not have is left out. */
class AndroidCues(private val context: Context) : Cues {
    private val tones = runCatching { ToneGenerator(AudioManager.STREAM_MUSIC, ToneGenerator.MAX_VOLUME) }.getOrNull()
    private val vibrator = context.getSystemService(Vibrator::class.java)
    private var canSpeak = false
    private val voice: TextToSpeech = TextToSpeech(context) { status -> begin(status) }

    private fun begin(status: Int) {
        canSpeak = status == TextToSpeech.SUCCESS
        if (canSpeak) voice.language = Locale.getDefault()
    }

    override fun tell(cue: Cue) {
        val way = wayOf(cue)
        tones?.startTone(way.tone, TONE_MS)
        vibrator?.vibrate(VibrationEffect.createWaveform(way.pulsesMs, NO_REPEAT))
        if (canSpeak) voice.speak(context.getString(way.words), TextToSpeech.QUEUE_FLUSH, null, cue.name)
    }

    override fun close() {
        voice.shutdown()
        tones?.release()
        vibrator?.cancel()
    }

    private companion object {
        const val TONE_MS = 400
        const val NO_REPEAT = -1
    }
}

/** How a cue is told; pauses and pulses in turn, ms. */
private class Way(@StringRes val words: Int, val tone: Int, vararg val pulsesMs: Long)

private fun wayOf(cue: Cue): Way = when (cue) {
    Cue.RELEASE_NOW -> Way(R.string.cue_release, ToneGenerator.TONE_PROP_BEEP2, 0, 200)
    Cue.RECORDING -> Way(R.string.cue_recording, ToneGenerator.TONE_PROP_BEEP, 0, 80)
    Cue.GOOD -> Way(R.string.cue_good, ToneGenerator.TONE_PROP_ACK, 0, 80, 80, 80)
    Cue.TOUCHED -> Way(R.string.cue_touched, ToneGenerator.TONE_PROP_NACK, 0, 400)
    Cue.REPEAT -> Way(R.string.cue_repeat, ToneGenerator.TONE_PROP_NACK, 0, 400, 200, 400)
    Cue.DONE -> Way(R.string.cue_done, ToneGenerator.TONE_CDMA_CONFIRM, 0, 80, 80, 80, 80, 80)
}
