package rasterlab.grader

import picocli.CommandLine
import picocli.CommandLine.MissingParameterException
import picocli.CommandLine.OverwrittenOptionException
import picocli.CommandLine.ParameterException
import picocli.CommandLine.UnmatchedArgumentException
import java.text.MessageFormat
import java.util.Locale
import java.util.ResourceBundle

/** What the server says to who starts it, in one language. */
internal class CommandWords private constructor(
    val language: Locale,
) {
    private val bundle: ResourceBundle =
        ResourceBundle.getBundle(
            "rasterlab.grader.command",
            language,
            ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES),
        )

    /** @param values for the places {0}, {1}, … of the text */
    fun say(
        key: String,
        vararg values: Any,
    ): String = MessageFormat(bundle.getString(key), Locale.ROOT).format(values)

    /** Help in this language; English stands with the commands. */
    fun wear(command: CommandLine): CommandLine =
        if (language == Locale.ENGLISH) command else command.setResourceBundle(bundle)

    fun of(failure: ParameterException): String =
        when {
            language == Locale.ENGLISH -> {
                failure.message.orEmpty()
            }

            failure is UnmatchedArgumentException -> {
                say(if (failure.isUnknownOption) "unknown.option" else "unknown.argument", failure.unmatched.first())
            }

            failure is MissingParameterException -> {
                say("missing", failure.missing.joinToString { name(it) })
            }

            failure is OverwrittenOptionException -> {
                say("twice", name(failure.overwritten))
            }

            failure.argSpec != null -> {
                say("invalid", name(failure.argSpec), failure.value.orEmpty())
            }

            else -> {
                failure.message.orEmpty()
            }
        }

    private fun name(argument: CommandLine.Model.ArgSpec): String =
        (argument as? CommandLine.Model.OptionSpec)?.longestName() ?: argument.paramLabel()

    companion object {
        private val RUSSIAN = Locale.forLanguageTag("ru")

        /** What `--lang` asks for, whatever is wrong with the other arguments; else English. */
        fun asked(vararg arguments: String): CommandWords {
            val words = arguments.joinToString("\n").lowercase(Locale.ROOT) + "\n"
            return CommandWords(if (Regex("(^|\n)--lang[\n=]ru\n").containsMatchIn(words)) RUSSIAN else Locale.ENGLISH)
        }
    }
}
