package rasterlab.grader

import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec

/** Shows the help of a command below its own, named step by step: `help course list`, or `course help list`. */
@Command(
    name = "help",
    helpCommand = true,
    description = ["Shows the help of a command. Without COMMAND it lists the commands."],
)
internal class ServerHelpCommand(
    private val words: CommandWords,
) : Runnable {
    @Spec
    lateinit var spec: CommandSpec

    @Option(names = ["-h", "--help"], usageHelp = true, description = ["Shows this help and exits."])
    var help = false

    @Parameters(
        arity = "0..*",
        paramLabel = "COMMAND",
        description = ["The command, and the one below it if there is one."],
    )
    var names: List<String> = emptyList()

    override fun run() {
        val shown = names.fold(spec.parent().commandLine(), ::below)
        shown.usage(shown.out)
    }

    private fun below(
        command: CommandLine,
        name: String,
    ): CommandLine = command.subcommands[name] ?: throw ParameterException(command, words.unknownCommand(command, name))
}
