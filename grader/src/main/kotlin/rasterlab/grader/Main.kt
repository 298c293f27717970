package rasterlab.grader

import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ScopeType
import picocli.CommandLine.Spec
import rasterlab.engine.ProductVersion
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.web.PageTexts
import java.io.OutputStreamWriter
import java.io.PrintStream
import java.io.PrintWriter
import java.nio.charset.StandardCharsets
import java.nio.file.Path
import kotlin.system.exitProcess

private const val BAD_INPUT = 2

/** Letters in a line, as in the help of ./lab. */
private const val HELP_WIDTH = 100

/** EX_SOFTWARE of sysexits.h: nothing that the person who started the server can put right in the command. */
private const val OUR_FAULT = 70

@Command(
    name = "./lab grader",
    mixinStandardHelpOptions = true,
    versionProvider = GraderVersion::class,
    description = ["The grading server of Rasterlab."],
)
private class GraderProgram(
    private val words: CommandWords,
) : Runnable {
    @Spec
    lateinit var spec: CommandSpec

    @Option(
        names = ["--lang"],
        paramLabel = "LANGUAGE",
        scope = ScopeType.INHERIT,
        description = [
            "Language of what is printed here, en or ru; default: en.",
            "The lines with the address and the token are the same in both, its log is in English,",
            "and the server's pages are in their reader's language.",
        ],
    )
    var language = Tongue.EN

    override fun run(): Unit = throw CommandLine.ParameterException(spec.commandLine(), words.say("command"))
}

internal enum class Tongue {
    EN,
    RU,
    ;

    /** Lower-case, as it is typed. */
    override fun toString() = name.lowercase()
}

private class GraderVersion : CommandLine.IVersionProvider {
    override fun getVersion() = arrayOf("Rasterlab ${ProductVersion.text()}")
}

fun main(arguments: Array<String>) {
    exitProcess(commandLine(CommandWords.asked(*arguments)).execute(*arguments))
}

/** Every failure ends in one line; its stack is in the log, if there is one already. */
internal fun commandLine(words: CommandWords = CommandWords.asked()): CommandLine =
    words
        .wear(programOf(words))
        .setUsageHelpWidth(HELP_WIDTH)
        .registerConverter(Path::class.java, ::named)
        .setCaseInsensitiveEnumValuesAllowed(true)
        .setOut(utf8(System.out))
        .setErr(utf8(System.err))
        .setParameterExceptionHandler { failure, _ -> refuse(failure.commandLine, words.of(failure)) }
        .setExecutionExceptionHandler { failure, command, _ ->
            val log = logOnlyToFile(failure)
            when (failure) {
                is CannotStart -> {
                    refuse(command, failure.said(words.language))
                }

                is Rejection.Explained -> {
                    refuse(command, failure.said(words.language))
                }

                is Rejection.BadName -> {
                    refuse(command, PageTexts.of(words.language.language).problem(failure.code))
                }

                is Rejection.UnknownStaff -> {
                    refuse(command, CannotStart(StartFailure.NO_STAFF, failure.id).said(words.language))
                }

                is Rejection.UnknownPlatform -> {
                    refuse(command, CannotStart(StartFailure.NO_PLATFORM, failure.id).said(words.language))
                }

                is Rejection.LastInstructor -> {
                    refuse(command, CannotStart(StartFailure.LAST_INSTRUCTOR).said(words.language))
                }

                is Rejection.UnknownStudent -> {
                    refuse(
                        command,
                        CannotStart(StartFailure.NO_STUDENT, failure.id).said(words.language),
                    )
                }

                else -> {
                    giveUp(command, words, failure, log)
                }
            }
        }

private fun programOf(words: CommandWords): CommandLine =
    CommandLine(GraderProgram(words))
        .addSubcommand(ServeCommand(words))
        .addSubcommand(WorkerCommand(words))
        .addSubcommand(BackupCommand(words))
        .addSubcommand(RestoreCommand(words))
        .addSubcommand(TokenCommand())
        .addSubcommand(
            CommandLine(CourseCommand(words))
                .addSubcommand(CourseListCommand())
                .addSubcommand(CourseCreateCommand())
                .addSubcommand(CourseRosterCommand(words))
                .addSubcommand(CourseExercisesCommand(words))
                .addSubcommand(CourseRulesCommand(words))
                .addSubcommand(CourseExtendCommand(words))
                .addSubcommand(CourseCloneCommand())
                .addSubcommand(CourseGradesCommand())
                .addSubcommand(ServerHelpCommand(words)),
        ).addSubcommand(studentCommands(words))
        .addSubcommand(ExportCommand(words))
        .addSubcommand(
            CommandLine(StaffCommand(words))
                .addSubcommand(StaffListCommand())
                .addSubcommand(StaffAddCommand())
                .addSubcommand(StaffTokenCommand())
                .addSubcommand(StaffRenameCommand())
                .addSubcommand(StaffCourseCommand())
                .addSubcommand(StaffRevokeCommand())
                .addSubcommand(ServerHelpCommand(words)),
        ).addSubcommand(regradeCommands(words))
        .addSubcommand(ltiCommands(words))
        .addSubcommand(ServerHelpCommand(words))

/** An empty name would stand for the folder that the server is started in. */
private fun named(path: String): Path =
    if (path.isEmpty()) throw CommandLine.TypeConversionException("must not be empty") else Path.of(path)

private fun giveUp(
    command: CommandLine,
    words: CommandWords,
    failure: Exception,
    log: String?,
): Int {
    val place = if (log == null) words.say("log.none") else words.say("log", log)
    refuse(command, words.say("failed", failure.reason(), place))
    return OUR_FAULT
}

private fun utf8(stream: PrintStream) = PrintWriter(OutputStreamWriter(stream, StandardCharsets.UTF_8), true)

/** The message on one line, also where the name of a file goes over several. */
internal fun oneLine(message: String) = message.replace(Regex("\\p{Cntrl}+"), " ").trim()

private fun refuse(
    command: CommandLine,
    message: String,
): Int {
    command.err.println("${command.commandSpec.qualifiedName()}: ${oneLine(message)}")
    return BAD_INPUT
}
