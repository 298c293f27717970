package rasterlab.grader.storage

import java.text.MessageFormat
import java.util.Locale
import java.util.ResourceBundle

/**
 * The server cannot start; the message is one line for the person who started it.
 *
 * @param key of the reason among the words beside this class
 * @param values for the places {0}, {1}, … of the words
 */
class CannotStart(
    private val key: String,
    vararg values: Any,
    cause: Throwable? = null,
) : Exception(cause) {
    private val values = values.map(Any::toString).toTypedArray()

    override val message: String = said(Locale.ENGLISH)

    fun said(language: Locale): String {
        val onlyAsked = ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES)
        val words = ResourceBundle.getBundle("rasterlab.grader.storage.reasons", language, onlyAsked)
        return MessageFormat(words.getString(key), Locale.ROOT).format(values)
    }
}
