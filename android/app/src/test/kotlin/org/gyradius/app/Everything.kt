package org.gyradius.app

import kotlin.system.exitProcess
import org.junit.internal.TextListener
import org.junit.runner.Description
import org.junit.runner.JUnitCore
import org.junit.runner.notification.RunListener

/** Runs test classes and says of each test how long it took. */
fun main(classes: Array<String>) {
    val core = JUnitCore()
    core.addListener(TextListener(System.out))
    core.addListener(Clock)
    val result = core.run(*classes.map { Class.forName(it) }.toTypedArray())
    exitProcess(if (result.wasSuccessful()) 0 else 1)
}

private object Clock : RunListener() {
    private var fromNs = 0L

    override fun testStarted(description: Description) {
        fromNs = System.nanoTime()
    }

    override fun testFinished(description: Description) {
        println(" %.1f s %s: %s".format((System.nanoTime() - fromNs) / 1e9, description.testClass.simpleName, description.methodName))
    }
}
