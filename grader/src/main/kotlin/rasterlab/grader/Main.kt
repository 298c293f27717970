package rasterlab.grader

import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.HelpCommand
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Spec
import rasterlab.grader.storage.CannotStart
import kotlin.system.exitProcess

private const val BAD_INPUT = 2

@Command(
    name = "./lab grader",
    mixinStandardHelpOptions = true,
    version = ["rasterlab 0.1.0"],
    description = ["The grading server of Rasterlab."],
    subcommands = [ServeCommand::class, HelpCommand::class],
)
private class GraderCommand : Runnable {
    @Spec
    lateinit var spec: CommandSpec

    override fun run(): Unit =
        throw CommandLine.ParameterException(spec.commandLine(), "which command? see ./lab grader --help")
}

fun main(arguments: Array<String>) {
    val exit =
        CommandLine(GraderCommand())
            .setParameterExceptionHandler { failure, _ -> refuse(failure.commandLine, failure.message) }
            .setExecutionExceptionHandler { failure, command, _ ->
                if (failure !is CannotStart) throw failure
                refuse(command, failure.message)
            }.execute(*arguments)
    exitProcess(exit)
}

private fun refuse(
    command: CommandLine,
    message: String?,
): Int {
    command.err.println("${command.commandSpec.qualifiedName()}: ${message.orEmpty().lineSequence().first()}")
    return BAD_INPUT
}
