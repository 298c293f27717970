package rasterlab.grader

import picocli.CommandLine
import picocli.CommandLine.MissingParameterException
import picocli.CommandLine.OverwrittenOptionException
import picocli.CommandLine.ParameterException
import picocli.CommandLine.UnmatchedArgumentException
import rasterlab.engine.naming.Closest
import rasterlab.grader.wording.Wording
import java.util.Locale

/** The messages of the server to the person who starts it, in one language. */
internal class CommandWords private constructor(
    val language: Locale,
) {
    private val wording = Wording("rasterlab.grader.command", language)

    /** @param values for the places {0}, {1}, … of the text */
    fun say(
        key: String,
        vararg values: String,
    ): String = wording.say(key, *values)

    /** Help in this language; English stands with the commands, but for the options that picocli adds. */
    fun wear(command: CommandLine): CommandLine = command.setResourceBundle(wording.bundle).also { tellExits(it) }

    /** Lists the exit codes in the help of the command and of those below it. */
    private fun tellExits(command: CommandLine) {
        command.commandSpec
            .usageMessage()
            .exitCodeListHeading("%n${say("exits")}%n")
            .exitCodeList(EXITS.associateWith { say("exits.$it") })
        command.subcommands.values.forEach(::tellExits)
    }

    /**
     * The failure in English as picocli has it, but for a command, which is told with those there
     * are.
     */
    fun of(failure: ParameterException): String =
        when {
            failure is UnmatchedArgumentException && !failure.isUnknownOption && failure.hasCommands() -> {
                unknownCommand(failure.commandLine, failure.unmatched.first())
            }

            failure.argSpec?.type()?.isEnum == true && failure.value != null -> {
                unknownWord(failure.argSpec, failure.value)
            }

            failure.argSpec?.type() == Int::class.javaPrimitiveType && failure.value != null -> {
                val range = ServeCommand.RANGES[name(failure.argSpec)]
                val key = if (range == null) "whole" else "whole.range"
                say(key, name(failure.argSpec), failure.value, "${range?.first}", "${range?.last}")
            }

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

    private fun ParameterException.hasCommands() = commandLine.subcommands.isNotEmpty()

    /** Says that [command] has none of that name, those it has, and which may have been meant. */
    fun unknownCommand(
        command: CommandLine,
        name: String,
    ): String {
        val known = command.subcommands.keys
        val complaint = say("unknown.command", name, known.joinToString())
        return Closest.to(name, known).map { say("near", complaint, it) }.orElse(complaint)
    }

    /** Says which words an option takes, and which may have been meant. */
    private fun unknownWord(
        argument: CommandLine.Model.ArgSpec,
        value: String,
    ): String {
        val known = argument.type().enumConstants.map { "$it".lowercase(Locale.ROOT) }
        val complaint = say("unknown.word", name(argument), known.joinToString(), value)
        return Closest.to(value, known).map { say("near", complaint, it) }.orElse(complaint)
    }

    private fun name(argument: CommandLine.Model.ArgSpec): String =
        (argument as? CommandLine.Model.OptionSpec)?.longestName() ?: argument.paramLabel()

    companion object {
        private val RUSSIAN = Locale.forLanguageTag("ru")

        /** The exit codes of every command. */
        private val EXITS = listOf("0", "2", "70")

        /** The language that `--lang` asks for, whatever is wrong with the other arguments; else English. */
        fun asked(vararg arguments: String): CommandWords {
            val words = arguments.joinToString("\n").lowercase(Locale.ROOT) + "\n"
            return CommandWords(if (Regex("(^|\n)--lang[\n=]ru\n").containsMatchIn(words)) RUSSIAN else Locale.ENGLISH)
        }
    }
}
