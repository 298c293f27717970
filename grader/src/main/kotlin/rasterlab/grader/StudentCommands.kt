package rasterlab.grader

import kotlinx.serialization.json.Json
import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import rasterlab.grader.course.Courses
import rasterlab.grader.course.told
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.storage.Database
import rasterlab.grader.student.StudentRecords
import rasterlab.grader.student.readable
import rasterlab.grader.student.zipped
import java.time.InstantSource
import java.util.concurrent.Callable

internal fun studentCommands(words: CommandWords): CommandLine =
    CommandLine(StudentCommand(words))
        .addSubcommand(StudentListCommand())
        .addSubcommand(StudentShowCommand())
        .addSubcommand(StudentExportCommand(words))
        .addSubcommand(StudentDeleteCommand(words))
        .addSubcommand(ServerHelpCommand(words))

/** Works on what a server keeps about students, on its machine; the server may run meanwhile. */
@Command(
    name = "student",
    mixinStandardHelpOptions = true,
    description = ["Lists and shows students, writes out all that is kept about one, and deletes it."],
)
private class StudentCommand(
    private val words: CommandWords,
) : Runnable {
    @Spec
    lateinit var spec: CommandSpec

    override fun run(): Unit = throw ParameterException(spec.commandLine(), words.say("command"))
}

/** Which student of which server is meant. */
internal class StudentOptions {
    @Mixin
    lateinit var of: DataOptions

    @Parameters(
        index = "0",
        paramLabel = "STUDENT",
        descriptionKey = "student.id",
        description = ["The student's id, as list prints it."],
    )
    lateinit var student: String

    fun <T> open(work: (Database, StudentRecords) -> T): T =
        of.open().use { work(it, StudentRecords(it, InstantSource.system())) }
}

/** Whether a program reads what is printed. */
internal class JsonOptions {
    @Option(
        names = ["--json"],
        descriptionKey = "student.json",
        description = ["Prints JSON, as the HTTP API has it."],
    )
    var json = false
}

@Command(
    name = "list",
    mixinStandardHelpOptions = true,
    description = [
        "Prints the students of a course, a line for each.",
        "It has id, number, ID number, e-mail address and name; '-' stands for what no roster said.",
    ],
)
private class StudentListCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var options: CourseOptions

    @Mixin
    lateinit var form: JsonOptions

    override fun call(): Int =
        options.open { _, courses ->
            val course = courses.find(options.course) ?: throw options.unknown()
            val students = courses.students(course.id).orEmpty().map { it.told(withRoster = true) }
            val out = spec.commandLine().out
            if (form.json) out.println(Json.encodeToString(students))
            for (one in students.takeUnless { form.json }.orEmpty()) {
                val told = listOf(one.student, "${one.number}", one.idNumber ?: "-", one.email ?: "-", one.shownName)
                out.println(told.joinToString("\t"))
            }
            0
        }
}

@Command(
    name = "show",
    mixinStandardHelpOptions = true,
    description = ["Prints who a student is and how much they submitted."],
)
private class StudentShowCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var options: StudentOptions

    @Mixin
    lateinit var form: JsonOptions

    override fun call(): Int =
        options.open { database, records ->
            val kept = records.look(options.student)
            val courses = Courses(database, InstantSource.system())
            val one = courses.student(kept.course, kept.student).told(withRoster = true)
            val lines =
                listOf(
                    "student" to one.student,
                    "course" to courses.find(kept.course)?.code,
                    "number" to "${one.number}",
                    "name" to one.name,
                    "shown-name" to one.shownName,
                    "id-number" to one.idNumber,
                    "email" to one.email,
                    "joined" to one.joinedAt,
                    "submissions" to "${kept.submissions.size}",
                )
            val out = spec.commandLine().out
            if (form.json) out.println(Json.encodeToString(one))
            // The lines are the same in every language, for programs.
            if (!form.json) lines.forEach { (field, value) -> out.println("$field\t${value.orEmpty()}".trim()) }
            0
        }
}

/** The ways to write out what is kept about a student. */
internal enum class StudentForm {
    JSON,
    ZIP,
    ;

    /** Lower-case, as it is typed. */
    override fun toString() = name.lowercase()
}

@Command(
    name = "export",
    mixinStandardHelpOptions = true,
    description = [
        "Writes all that is kept about a student, as a JSON document or a ZIP file.",
        "The ZIP file also has each source as a file of its own. The server's record of changes notes the export.",
    ],
)
private class StudentExportCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var options: StudentOptions

    @Option(
        names = ["--as"],
        paramLabel = "FORM",
        descriptionKey = "student.as",
        description = ["json or zip; default: \${DEFAULT-VALUE}."],
    )
    var form = StudentForm.JSON

    @Mixin
    lateinit var output: OutputOptions

    @Mixin
    lateinit var catalogue: CatalogueOptions

    override fun call(): Int {
        if (form == StudentForm.ZIP && output.to == null) {
            throw ParameterException(spec.commandLine(), words.say("student.zip"))
        }
        output.requireNew()
        val ending = Exercises(catalogue.read().all())::ending
        return options.open { _, records ->
            val kept = records.export(options.student, by = "command")
            when (form) {
                StudentForm.JSON -> output.write(spec, "${readable.encodeToString(kept)}\n".toByteArray())
                StudentForm.ZIP -> output.write(spec, zipped(kept, ending))
            }
            0
        }
    }
}

@Command(
    name = "delete",
    mixinStandardHelpOptions = true,
    description = [
        "Deletes a student and all that is kept about them, for good.",
        "Without --yes it only says what that would be.",
    ],
)
private class StudentDeleteCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var options: StudentOptions

    @Option(names = ["--yes"], descriptionKey = "student.yes", description = ["Deletes it."])
    var sure = false

    override fun call(): Int =
        options.open { _, records ->
            if (!sure) {
                val kept = records.look(options.student)
                val told = words.say("student.sure", kept.shownName, "${kept.submissions.size}")
                throw ParameterException(spec.commandLine(), told)
            }
            val gone = records.delete(options.student, by = "command")
            spec.commandLine().out.println("deleted\t${gone.student}\nsubmissions\t${gone.submissions.size}")
            0
        }
}
