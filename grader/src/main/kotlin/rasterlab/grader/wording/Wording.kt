// What this server says, by keys: texts stand in properties beside who says them, a file for each language.
package rasterlab.grader.wording

import java.text.MessageFormat
import java.util.Locale
import java.util.ResourceBundle

/**
 * The texts of one file in one language; numbers take that language's form, strings stay.
 *
 * @param name the file with its package, such as rasterlab.grader.command
 */
class Wording(
    name: String,
    val language: Locale,
) {
    /** The bundle for a library that looks up its own keys. */
    val bundle: ResourceBundle =
        ResourceBundle.getBundle(
            name,
            language,
            ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES),
        )

    fun has(key: String): Boolean = bundle.containsKey(key)

    /** @param values for the places {0}, {1}, … of the text */
    fun say(
        key: String,
        vararg values: Any,
    ): String = MessageFormat(bundle.getString(key), language).format(values)
}
