package rasterlab.grader

import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import rasterlab.grader.comment.copyKeptComments
import rasterlab.grader.course.Name
import rasterlab.grader.rules.CourseClones
import rasterlab.grader.rules.CourseExercises
import rasterlab.grader.rules.CourseRules
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.rules.RepeatedHour
import rasterlab.grader.rules.RuleChange
import rasterlab.grader.rules.RuleField
import rasterlab.grader.rules.named
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.storage.text
import java.time.InstantSource
import java.util.concurrent.Callable

/** The exercise that a rule is for, and its course. */
internal class ExerciseOptions {
    @Mixin
    lateinit var of: CourseOptions

    @Mixin
    lateinit var catalogue: CatalogueOptions

    @Parameters(
        index = "1",
        paramLabel = "EXERCISE",
        descriptionKey = "rules.exercise",
        description = ["The exercise's name."],
    )
    lateinit var exercise: String

    /** The name, where there is such an exercise. */
    fun known(): String =
        exercise.takeIf { name -> catalogue.read().all().any { it.id() == name } }
            ?: throw CannotStart(StartFailure.NO_EXERCISE, exercise)
}

@Command(
    name = "rules",
    mixinStandardHelpOptions = true,
    description = [
        "Prints the rules of an exercise in a course, after changing those that are given.",
        "A time is a moment with its offset, or one of the zone; an empty value takes a rule away.",
    ],
)
internal class CourseRulesCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var exercise: ExerciseOptions

    @Option(
        names = ["--opens"],
        paramLabel = "TIME",
        descriptionKey = "rules.opens",
        description = ["Nothing is taken before."],
    )
    var opens: String? = null

    @Option(
        names = ["--deadline"],
        paramLabel = "TIME",
        descriptionKey = "rules.deadline",
        description = ["What comes later is late."],
    )
    var deadline: String? = null

    @Option(
        names = ["--zone"],
        paramLabel = "ZONE",
        descriptionKey = "rules.zone",
        description = ["Time zone, such as Europe/Moscow, by which late days are counted."],
    )
    var zone: String? = null

    @Option(
        names = ["--late-days"],
        paramLabel = "N",
        descriptionKey = "rules.days",
        description = ["How long after the deadline a submission counts; empty for any time."],
    )
    var lateDays: String? = null

    @Option(
        names = ["--attempts"],
        paramLabel = "N",
        descriptionKey = "rules.attempts",
        description = ["How often a student may submit what counts; empty for any number."],
    )
    var attempts: String? = null

    @Option(
        names = ["--policy"],
        paramLabel = "RULE",
        descriptionKey = "rules.policy",
        description = ["What counts: best, last or chosen."],
    )
    var policy: String? = null

    @Option(
        names = ["--late-penalty"],
        paramLabel = "PERCENT",
        descriptionKey = "rules.penalty",
        description = ["Percent of its points that late work loses per day begun after the late days; 0 for none."],
    )
    var latePenalty: String? = null

    override fun call(): Int =
        exercise.of.open { database, courses ->
            val course = courses.find(exercise.of.course) ?: throw exercise.of.unknown()
            val rules = CourseRules(database, InstantSource.system())
            val after = rules.change(course, exercise.known(), RuleChange(told()), by = "command")
            print(after)
            RepeatedHour.among(after).forEach { spec.commandLine().err.println(it.said(words.language)) }
            for (one in rules.extensions(course).filter { it.exercise == exercise.exercise }) {
                spec.commandLine().out.println(
                    "extension\t${one.student}\t${one.name}\t${one.due.text()}\t${one.reason}",
                )
            }
            0
        }

    private fun told(): Map<RuleField, String> {
        val given =
            mapOf(
                RuleField.OPENS to opens,
                RuleField.DEADLINE to deadline,
                RuleField.ZONE to zone,
                RuleField.LATE_DAYS to lateDays,
                RuleField.ATTEMPTS to attempts,
                RuleField.POLICY to policy,
                RuleField.LATE_PENALTY to latePenalty,
            )
        return given.mapNotNull { (field, text) -> text?.let { field to it } }.toMap()
    }

    /** The lines are the same in every language, for programs. */
    private fun print(rules: ExerciseRules) {
        val values =
            listOf(
                rules.opens?.text(),
                rules.due?.text(),
                rules.zone.named(),
                rules.lateDays?.toString(),
                rules.attempts?.toString(),
                rules.policy.code,
                rules.latePenalty.toString(),
            )
        RuleField.entries.zip(values).forEach { (field, value) ->
            spec.commandLine().out.println("${field.code}\t${value.orEmpty()}".trim())
        }
    }
}

@Command(
    name = "exercises",
    mixinStandardHelpOptions = true,
    description = [
        "Prints the exercises of a course, after choosing those that are given.",
        "Students get no other; an exam may have any.",
    ],
)
internal class CourseExercisesCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: CourseOptions

    @Mixin
    lateinit var catalogue: CatalogueOptions

    @Parameters(
        index = "1..*",
        paramLabel = "EXERCISE",
        descriptionKey = "rules.choice",
        description = ["Names of the exercises that the course is to have."],
    )
    var chosen: List<String> = emptyList()

    @Option(
        names = ["--all"],
        descriptionKey = "rules.choice.all",
        description = ["All that the server has, now and later."],
    )
    var all = false

    override fun call(): Int =
        of.open { database, courses ->
            val course = courses.find(of.course) ?: throw of.unknown()
            val known = catalogue.read().all().map { it.id() }
            val exercises = CourseExercises(database, known, InstantSource.system())
            chosen.firstOrNull { it !in known }?.let { throw CannotStart(StartFailure.NO_EXERCISE, it) }
            if (all && chosen.isNotEmpty()) throw ParameterException(spec.commandLine(), words.say("exercises.both"))
            if (all || chosen.isNotEmpty()) exercises.choose(course, chosen.takeUnless { all }, by = "command")
            exercises.of(course.id).forEach(spec.commandLine().out::println)
            0
        }
}

@Command(
    name = "extend",
    mixinStandardHelpOptions = true,
    description = ["Gives one student a later deadline, or takes it back."],
)
internal class CourseExtendCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var exercise: ExerciseOptions

    @Parameters(
        index = "2",
        paramLabel = "STUDENT",
        descriptionKey = "rules.student",
        description = ["The student's id."],
    )
    lateinit var student: String

    @Option(
        names = ["--until"],
        paramLabel = "TIME",
        required = true,
        descriptionKey = "rules.until",
        description = ["The new deadline; empty to take it back."],
    )
    lateinit var until: String

    @Option(
        names = ["--reason"],
        paramLabel = "TEXT",
        defaultValue = "",
        descriptionKey = "rules.reason",
        description = ["Why."],
    )
    lateinit var reason: String

    override fun call(): Int =
        exercise.of.open { database, courses ->
            val course = courses.find(exercise.of.course) ?: throw exercise.of.unknown()
            val rules = CourseRules(database, InstantSource.system())
            val holds = rules.extend(course, exercise.known(), student, until, reason, by = "command")
            spec.commandLine().out.println("deadline\t${holds.due?.text().orEmpty()}".trim())
            RepeatedHour.among(holds.zone, RuleField.DEADLINE.code to holds.due).forEach {
                spec.commandLine().err.println(it.said(words.language))
            }
            0
        }
}

@Command(
    name = "clone",
    mixinStandardHelpOptions = true,
    description = ["Makes a course with the rules of an earlier one, later by whole days, and nobody in it."],
)
internal class CourseCloneCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var options: CourseOptions

    @Parameters(
        index = "1",
        paramLabel = "NAME",
        descriptionKey = "rules.name",
        description = ["The new course's name."],
    )
    lateinit var name: String

    @Option(
        names = ["--days"],
        paramLabel = "N",
        defaultValue = "${CourseClones.YEAR_OF_WEEKS}",
        descriptionKey = "rules.shift",
        description = ["How many days later; by default \${DEFAULT-VALUE}, that is 52 weeks."],
    )
    lateinit var days: String

    override fun call(): Int =
        options.open { database, courses ->
            val course = courses.find(options.course) ?: throw options.unknown()
            val clones = CourseClones(database, InstantSource.system(), ::copyKeptComments)
            val made = clones.clone(course, Name.of(name), days, by = "command", key = null)
            spec.commandLine().out.println("course\t${made.id}\ncode\t${made.code}")
            0
        }
}
