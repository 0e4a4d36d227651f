package org.gyradius

/** What went wrong, in a sentence that says where. */
val GyradiusException.text: String
    get() = when (this) {
        is GyradiusException.BadFile -> text
        is GyradiusException.Unwritable -> text
        is GyradiusException.DiskFull -> text
        is GyradiusException.NoResult -> text
        is GyradiusException.BadArgument -> text
        is GyradiusException.Cancelled -> text
    }
