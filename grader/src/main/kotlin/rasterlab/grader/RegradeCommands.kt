package rasterlab.grader

import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import rasterlab.grader.regrade.CaseChange
import rasterlab.grader.regrade.Regrade
import rasterlab.grader.regrade.RegradeChange
import rasterlab.grader.regrade.RegradeChoice
import rasterlab.grader.regrade.RegradeState
import rasterlab.grader.regrade.Regrades
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.storage.text
import java.time.InstantSource
import java.util.concurrent.Callable

/** The commands that grade again, on the server's machine; the server does the grading. */
internal fun regradeCommands(words: CommandWords): CommandLine =
    CommandLine(RegradeCommand(words))
        .addSubcommand(RegradeStartCommand())
        .addSubcommand(RegradeListCommand())
        .addSubcommand(RegradeShowCommand(words))
        .addSubcommand(RegradeAcceptCommand(words))
        .addSubcommand(RegradeDiscardCommand(words))
        .addSubcommand(RegradeUndoCommand(words))
        .addSubcommand(ServerHelpCommand(words))

@Command(
    name = "regrade",
    mixinStandardHelpOptions = true,
    description = [
        "Grades submissions again: against the exercise as it is now, behind whatever students submit.",
        "The server does the grading; it may run meanwhile, or be started later.",
    ],
)
private class RegradeCommand(
    private val words: CommandWords,
) : Runnable {
    @Spec
    lateinit var spec: CommandSpec

    override fun run(): Unit = throw ParameterException(spec.commandLine(), words.say("command"))
}

@Command(
    name = "start",
    mixinStandardHelpOptions = true,
    description = [
        "Puts submissions of an exercise into the queue to be graded again, and prints the regrade's id.",
        "The new results count all together, when all are graded.",
    ],
)
private class RegradeStartCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var exercise: ExerciseOptions

    @Option(
        names = ["--of"],
        paramLabel = "CHOICE",
        descriptionKey = "regrade.of",
        description = ["Which: all, the latest of each student, or the best;", "default: \${DEFAULT-VALUE}."],
    )
    var of = "all"

    @Option(
        names = ["--submission"],
        paramLabel = "ID",
        descriptionKey = "regrade.submission",
        description = ["A submission's id; may be given several times, in the place of --of."],
    )
    var submissions: List<String> = emptyList()

    @Option(
        names = ["--dry-run"],
        descriptionKey = "regrade.dry",
        description = ["Lets nothing count before the regrade is accepted."],
    )
    var dry = false

    override fun call(): Int =
        exercise.of.open { database, courses ->
            val course = courses.find(exercise.of.course) ?: throw exercise.of.unknown()
            val known =
                exercise.catalogue
                    .read()
                    .all()
                    .firstOrNull { it.id() == exercise.exercise }
                    ?: throw CannotStart(StartFailure.NO_EXERCISE, exercise.exercise)
            val choice = if (submissions.isEmpty()) RegradeChoice.named(of) else RegradeChoice.SOME
            val regrades = Regrades(database, InstantSource.system())
            val begun = regrades.start(course, known, choice, submissions, dry, by = "command", key = null)
            spec.commandLine().out.println("regrade\t${begun.id}\nsubmissions\t${begun.total}")
            0
        }
}

@Command(
    name = "list",
    mixinStandardHelpOptions = true,
    description = ["Prints the regrades of a course, a line for each."],
)
private class RegradeListCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var options: CourseOptions

    override fun call(): Int =
        options.open { database, courses ->
            val course = courses.find(options.course) ?: throw options.unknown()
            for (one in Regrades(database, InstantSource.system()).ofCourse(course).items) {
                val told = listOf(one.id, one.begunAt.text(), one.exercise, one.choice.code, one.state.code)
                spec.commandLine().out.println((told + "${one.done}/${one.total}").joinToString("\t"))
            }
            0
        }
}

/** Which regrade of which server is meant. */
internal class RegradeOptions {
    @Mixin
    lateinit var of: DataOptions

    @Parameters(
        index = "0",
        paramLabel = "REGRADE",
        descriptionKey = "regrade.id",
        description = ["The regrade's id."],
    )
    lateinit var regrade: String

    fun <T> open(work: (Regrades) -> T): T = of.open().use { work(Regrades(it, InstantSource.system())) }
}

/** Prints where a regrade stands, after what is done with it. */
internal abstract class RegradeStep(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var options: RegradeOptions

    protected abstract fun step(
        regrades: Regrades,
        id: String,
    ): Regrade

    override fun call(): Int =
        options.open { regrades ->
            val regrade = step(regrades, options.regrade)
            val out = spec.commandLine().out
            out.println(words.say("regrade.stand", regrade.state.code, "${regrade.done}", "${regrade.total}"))
            if (regrade.failed > 0) out.println(words.say("regrade.failed", "${regrade.failed}"))
            if (regrade.state != RegradeState.GRADING) print(regrades.changes(regrade))
            0
        }

    private fun print(all: List<RegradeChange>) {
        val out = spec.commandLine().out
        val graded = all.filter { it.after != null }
        val counts = listOf(graded.count { it.gain > 0 }, graded.count { it.gain < 0 }, graded.count { it.gain == 0 })
        out.println(words.say("regrade.counts", *counts.map { "$it" }.toTypedArray()))
        for (one in graded.filter { it.gain != 0 || it.cases.isNotEmpty() }) {
            val points = listOf(one.before, one.after).map { "${it?.points}" }
            out.println(
                (listOf(one.submission, one.name) + points + one.cases.joinToString { told(it) }).joinToString("\t"),
            )
        }
    }

    private fun told(case: CaseChange) = "${case.name}: ${case.before?.first ?: "-"} > ${case.after?.first ?: "-"}"
}

@Command(
    name = "show",
    mixinStandardHelpOptions = true,
    description = [
        "Prints how many are graded, and at the end who gains and who loses.",
        "A line has a submission's id, its student, points before and after, cases that changed.",
    ],
)
internal class RegradeShowCommand(
    words: CommandWords,
) : RegradeStep(words) {
    override fun step(
        regrades: Regrades,
        id: String,
    ) = regrades.find(id)
}

@Command(
    name = "accept",
    mixinStandardHelpOptions = true,
    description = ["Lets the results of a dry run count."],
)
internal class RegradeAcceptCommand(
    words: CommandWords,
) : RegradeStep(words) {
    override fun step(
        regrades: Regrades,
        id: String,
    ) = regrades.accept(id, by = "command")
}

@Command(
    name = "discard",
    mixinStandardHelpOptions = true,
    description = ["Discards a regrade, also one that is still graded."],
)
internal class RegradeDiscardCommand(
    words: CommandWords,
) : RegradeStep(words) {
    override fun step(
        regrades: Regrades,
        id: String,
    ) = regrades.discard(id, by = "command")
}

@Command(
    name = "undo",
    mixinStandardHelpOptions = true,
    description = ["Lets the results from before an accepted regrade count again."],
)
internal class RegradeUndoCommand(
    words: CommandWords,
) : RegradeStep(words) {
    override fun step(
        regrades: Regrades,
        id: String,
    ) = regrades.undo(id, by = "command")
}
