package rasterlab.grader

import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.HelpCommand
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ScopeType
import picocli.CommandLine.Spec
import rasterlab.engine.ProductVersion
import rasterlab.grader.storage.CannotStart
import kotlin.system.exitProcess

private const val BAD_INPUT = 2

/** EX_SOFTWARE of sysexits.h: nothing that the person who started the server can put right in the command. */
private const val OUR_FAULT = 70

@Command(
    name = "./lab grader",
    mixinStandardHelpOptions = true,
    versionProvider = GraderVersion::class,
    description = ["The grading server of Rasterlab."],
    subcommands = [ServeCommand::class, HelpCommand::class],
)
private class GraderCommand : Runnable {
    @Spec
    lateinit var spec: CommandSpec

    @Option(
        names = ["--lang"],
        paramLabel = "LANGUAGE",
        scope = ScopeType.INHERIT,
        description = [
            "en or ru, taken as by every command of ./lab; what is printed here is in English,",
            "and the server's pages are in their reader's language.",
        ],
    )
    var language = Tongue.EN

    override fun run(): Unit =
        throw CommandLine.ParameterException(spec.commandLine(), "which command? see ./lab grader --help")
}

internal enum class Tongue { EN, RU }

private class GraderVersion : CommandLine.IVersionProvider {
    override fun getVersion() = arrayOf("Rasterlab ${ProductVersion.text()}")
}

fun main(arguments: Array<String>) {
    exitProcess(commandLine().execute(*arguments))
}

/** Every failure ends in one line; its stack is in the log, if there is one already. */
internal fun commandLine(): CommandLine =
    CommandLine(GraderCommand())
        .setCaseInsensitiveEnumValuesAllowed(true)
        .setParameterExceptionHandler { failure, _ -> refuse(failure.commandLine, failure.message) }
        .setExecutionExceptionHandler { failure, command, _ ->
            val log = logOnlyToFile(failure)
            if (failure is CannotStart) {
                refuse(command, failure.message)
            } else {
                giveUp(command, failure, log)
            }
        }

private fun giveUp(
    command: CommandLine,
    failure: Exception,
    log: String?,
): Int {
    val place = if (log == null) "there is no log yet" else "details in $log"
    refuse(command, "failed: ${failure.reason()}; $place")
    return OUR_FAULT
}

private fun refuse(
    command: CommandLine,
    message: String?,
): Int {
    command.err.println("${command.commandSpec.qualifiedName()}: ${message.orEmpty().lineSequence().first()}")
    return BAD_INPUT
}
