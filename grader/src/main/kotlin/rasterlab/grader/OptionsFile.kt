package rasterlab.grader

import com.fasterxml.jackson.core.JsonParser
import com.fasterxml.jackson.core.JsonProcessingException
import com.fasterxml.jackson.core.JsonToken
import com.fasterxml.jackson.dataformat.yaml.YAMLFactory
import picocli.CommandLine
import picocli.CommandLine.Model.OptionSpec
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Settings in YAML, one a line: the name of an option without its dashes, and its value. */
internal class OptionsFile private constructor(
    private val file: Path,
    private val settings: List<FileSetting>,
) {
    /** @param value a text, a whole number, true or false, as the file has it */
    class FileSetting(
        val name: String,
        val value: Any,
        val line: Int,
    )

    /** Sets the options of this command that its caller has not given. */
    fun applyTo(command: CommandLine) {
        val options =
            command.commandSpec
                .options()
                .filter { it.settingName() != null }
                .associateBy { it.settingName() }
        for (setting in settings) {
            val option =
                options[setting.name]
                    ?: throw CannotStart(
                        StartFailure.CONFIG_KEY,
                        file,
                        setting.line,
                        setting.name,
                        options.keys
                            .filterNotNull()
                            .sorted()
                            .joinToString(),
                    )
            val value = valueFor(option, setting)
            if (!command.parseResult.hasMatchedOption(option)) option.setValue<Any>(value)
        }
    }

    private fun OptionSpec.settingName(): String? = longestName().removePrefix("--").takeUnless { it in NEVER_IN_FILE }

    private fun valueFor(
        option: OptionSpec,
        setting: FileSetting,
    ): Any {
        val value = setting.value
        val text = (value as? String)?.takeUnless { it.isEmpty() || '\u0000' in it }

        fun refuse(expected: StartFailure): Nothing =
            throw CannotStart(expected, file, setting.line, setting.name, value)
        return when (option.type()) {
            Boolean::class.java -> value as? Boolean ?: refuse(StartFailure.CONFIG_TRUTH)
            Int::class.java -> (value as? Long)?.toIntOrNull() ?: refuse(StartFailure.CONFIG_NUMBER)
            Path::class.java -> text?.let(Path::of) ?: refuse(StartFailure.CONFIG_TEXT)
            else -> text ?: refuse(StartFailure.CONFIG_TEXT)
        }
    }

    private fun Long.toIntOrNull() = toInt().takeIf { it.toLong() == this }

    companion object {
        private const val MOST_BYTES = 64L shl 10

        /** Names options that are known before the file is read, or are no settings. */
        private val NEVER_IN_FILE = setOf("config", "heap", "help", "lang", "version")

        /** @throws CannotStart with the line of what is wrong */
        fun read(file: Path): OptionsFile {
            if (!Files.isRegularFile(file)) throw CannotStart(StartFailure.CONFIG_NONE, file)
            try {
                if (Files.size(file) > MOST_BYTES) throw CannotStart(StartFailure.CONFIG_LONG, file, MOST_BYTES)
                return YAMLFactory().createParser(Files.readString(file)).use { OptionsFile(file, settings(file, it)) }
            } catch (failure: JsonProcessingException) {
                val line = maxOf(failure.location?.lineNr ?: 1, 1)
                throw CannotStart(
                    StartFailure.CONFIG_YAML,
                    file,
                    line,
                    failure.originalMessage
                        .orEmpty()
                        .lines()
                        .first(),
                    cause = failure,
                )
            } catch (failure: IOException) {
                throw CannotStart(StartFailure.CONFIG_UNREADABLE, file, failure.reason(), cause = failure)
            }
        }

        private fun settings(
            file: Path,
            parser: JsonParser,
        ): List<FileSetting> {
            val settings = mutableListOf<FileSetting>()
            val first = parser.nextToken() ?: return settings
            if (first != JsonToken.START_OBJECT) throw CannotStart(StartFailure.CONFIG_SHAPE, file, parser.line())
            while (parser.nextToken() == JsonToken.FIELD_NAME) {
                val name = parser.currentName()
                val line = parser.line()
                if (settings.any { it.name == name }) throw CannotStart(StartFailure.CONFIG_TWICE, file, line, name)
                settings += FileSetting(name, value(parser.nextToken(), parser, file), line)
            }
            return settings
        }

        private fun value(
            token: JsonToken,
            parser: JsonParser,
            file: Path,
        ): Any =
            when (token) {
                JsonToken.VALUE_STRING -> parser.text
                JsonToken.VALUE_TRUE, JsonToken.VALUE_FALSE -> token == JsonToken.VALUE_TRUE
                JsonToken.VALUE_NUMBER_INT -> parser.text.toLongOrNull() ?: parser.text
                JsonToken.VALUE_NUMBER_FLOAT -> parser.decimalValue
                else -> throw CannotStart(StartFailure.CONFIG_SHAPE, file, parser.line())
            }

        private fun JsonParser.line() = currentTokenLocation().lineNr
    }
}
