package rasterlab.grader

import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import rasterlab.exercises.CatalogueException
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Name
import rasterlab.grader.course.RosterChange
import rasterlab.grader.course.RosterImport
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.storage.Database
import rasterlab.grader.wording.Wording
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.time.InstantSource
import java.util.concurrent.Callable

/** Works on a server's courses, on the server's machine; the server may run meanwhile. */
@Command(
    name = "course",
    mixinStandardHelpOptions = true,
    description = ["Makes and lists courses, takes rosters, sets rules and writes marks."],
)
internal class CourseCommand(
    private val words: CommandWords,
) : Runnable {
    @Spec
    lateinit var spec: CommandSpec

    override fun run(): Unit = throw ParameterException(spec.commandLine(), words.say("command"))
}

/** Which course of which server is meant. */
internal class CourseOptions {
    @Mixin
    lateinit var of: DataOptions

    @Parameters(
        index = "0",
        paramLabel = "COURSE",
        descriptionKey = "course.of",
        description = ["The course's id, or the code that students join with."],
    )
    lateinit var course: String

    /** Runs [work] with the database and the course in it. */
    fun <T> open(work: (Database, Courses) -> T): T = of.open().use { work(it, Courses(it, InstantSource.system())) }

    fun unknown() = CannotStart(StartFailure.NO_COURSE, course)
}

/** The exercises of a server. */
internal class CatalogueOptions {
    @Option(
        names = ["--exercises"],
        paramLabel = "DIR",
        descriptionKey = "course.exercises",
        description = ["Folder of more exercises, as serve has it."],
    )
    var exercises: Path? = null

    fun read(): Catalogue =
        try {
            val builtIn = Catalogue.builtIn()
            exercises?.let(builtIn::withFolder) ?: builtIn
        } catch (failure: CatalogueException) {
            throw CannotStart(StartFailure.EXERCISES, failure)
        }
}

@Command(
    name = "list",
    mixinStandardHelpOptions = true,
    description = ["Prints id, code, number of students and name of each course, a line for each."],
)
internal class CourseListCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: DataOptions

    override fun call(): Int {
        of.open().use { database ->
            val courses = Courses(database, InstantSource.system())
            for (course in courses.all()) {
                val students = courses.students(course.id).orEmpty().size
                spec.commandLine().out.println("${course.id}\t${course.code}\t$students\t${course.name}")
            }
        }
        return 0
    }
}

@Command(
    name = "create",
    mixinStandardHelpOptions = true,
    description = ["Makes a course, and prints its id and the code that students join with."],
)
internal class CourseCreateCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: DataOptions

    @Parameters(index = "0", paramLabel = "NAME", descriptionKey = "rules.name", description = ["The course's name."])
    lateinit var name: String

    override fun call(): Int {
        of.open().use { database ->
            val made = Courses(database, InstantSource.system()).create(by = "command", Name.of(name), key = null)
            spec.commandLine().out.println("course\t${made.id}\ncode\t${made.code}")
        }
        return 0
    }
}

@Command(
    name = "roster",
    mixinStandardHelpOptions = true,
    description = [
        "Brings a course's students to what a CSV file says: an export of Moodle or Canvas, or a table with names.",
        "Prints the token of each new student, this once. Nobody is taken out.",
    ],
)
internal class CourseRosterCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var options: CourseOptions

    @Parameters(index = "1", paramLabel = "FILE", descriptionKey = "course.file", description = ["The CSV file."])
    lateinit var file: Path

    @Option(
        names = ["--dry-run"],
        descriptionKey = "course.dry",
        description = ["Prints what would change, and changes nothing."],
    )
    var dry = false

    override fun call(): Int =
        options.open { database, courses ->
            val course = courses.find(options.course) ?: throw options.unknown()
            print(
                RosterImport(database, InstantSource.system()).apply(course, bytes(), dry, by = "command", key = null),
            )
            0
        }

    private fun bytes(): ByteArray =
        try {
            Files.readAllBytes(file)
        } catch (failure: IOException) {
            throw CannotStart(StartFailure.ROSTER_FILE, file, cause = failure)
        }

    private fun print(change: RosterChange) {
        val pages = Wording("rasterlab.grader.web.texts", words.language)
        val out = spec.commandLine().out
        change.added.forEach { out.println(words.say("roster.added", it.name, it.token.orEmpty()).trim()) }
        change.corrected.forEach { one ->
            val key = if (one.from == one.to) "roster.noted" else "roster.corrected"
            out.println(words.say(key, one.from, one.to))
            one.changes.forEach {
                val field = pages.say("roster.field.${it.field}")
                out.println("  " + words.say("roster.change", field, it.from ?: "-", it.to))
            }
        }
        change.missing.forEach { out.println(words.say("roster.missing", it.shownName)) }
        if (change.unused.isNotEmpty()) out.println(words.say("roster.unused", change.unused.joinToString()))
        val counts = listOf(change.added, change.corrected).map { "${it.size}" } + "${change.unchanged}"
        out.println(words.say(if (dry) "roster.would" else "roster.done", *counts.toTypedArray()))
    }
}

@Command(
    name = "grades",
    mixinStandardHelpOptions = true,
    description = ["Writes the marks of a course as CSV to standard output."],
)
internal class CourseGradesCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var marks: MarksOptions

    override fun call(): Int {
        spec.commandLine().out.print(marks.read("en"))
        spec.commandLine().out.flush()
        return 0
    }
}
