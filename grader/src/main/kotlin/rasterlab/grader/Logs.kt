package rasterlab.grader

import ch.qos.logback.classic.Level
import ch.qos.logback.classic.Logger
import ch.qos.logback.classic.LoggerContext
import ch.qos.logback.classic.encoder.JsonEncoder
import ch.qos.logback.classic.spi.ILoggingEvent
import ch.qos.logback.classic.spi.LoggingEvent
import ch.qos.logback.core.rolling.FixedWindowRollingPolicy
import ch.qos.logback.core.rolling.RollingFileAppender
import ch.qos.logback.core.rolling.SizeBasedTriggeringPolicy
import ch.qos.logback.core.util.FileSize
import org.slf4j.LoggerFactory
import rasterlab.grader.storage.makeOwnerOnly
import java.nio.file.Path

private const val FILE = "file"
private const val KEPT_FILES = 5
private const val FILE_BYTES = 10L shl 20

/** Writes the log to [file] from now on, one JSON object a line; warnings go to stderr too (logback.xml). */
internal fun logTo(file: Path) {
    val logs = LoggerFactory.getILoggerFactory() as LoggerContext
    val appender =
        OwnersLog().apply {
            context = logs
            name = FILE
            this.file = file.toString()
        }
    appender.encoder = JsonEncoder().apply { context = logs }.also { it.start() }
    appender.rollingPolicy =
        FixedWindowRollingPolicy()
            .apply {
                context = logs
                setParent(appender)
                fileNamePattern = "$file.%i"
                minIndex = 1
                maxIndex = KEPT_FILES
            }.also { it.start() }
    appender.triggeringPolicy =
        SizeBasedTriggeringPolicy<ILoggingEvent>()
            .apply {
                context = logs
                maxFileSize = FileSize(FILE_BYTES)
            }.also { it.start() }
    appender.start()
    val root = logs.getLogger(Logger.ROOT_LOGGER_NAME)
    root.addAppender(appender)
    // This loads the classes that write a failure while their files can still be opened.
    appender.encoder.encode(LoggingEvent(Logger::class.java.name, root, Level.DEBUG, "", Exception(), null))
}

/** Each new file of the log is for its owner only. */
private class OwnersLog : RollingFileAppender<ILoggingEvent>() {
    override fun openFile(name: String) {
        makeOwnerOnly(Path.of(name))
        super.openFile(name)
    }
}

/** Logs a failure with its stack, not to stderr; returns the log's name, or null if none is written yet. */
internal fun logOnlyToFile(failure: Throwable): String? {
    val root = LoggerFactory.getLogger(Logger.ROOT_LOGGER_NAME) as Logger
    val appender = root.getAppender(FILE) as? RollingFileAppender ?: return null
    appender.doAppend(LoggingEvent(Logger::class.java.name, root, Level.ERROR, "the server ends", failure, null))
    return appender.file
}

/** The root cause of a failure, in one line. */
internal fun Throwable.reason(): String {
    val bottom = generateSequence(this) { it.cause }.last()
    val words =
        bottom.message
            .orEmpty()
            .lineSequence()
            .firstOrNull { it.isNotBlank() }
    return listOfNotNull(bottom.javaClass.simpleName, words).joinToString(": ")
}
