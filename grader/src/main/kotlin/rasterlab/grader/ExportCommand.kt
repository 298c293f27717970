package rasterlab.grader

import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Spec
import rasterlab.grader.course.Courses
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.report.Grades
import rasterlab.grader.report.GradesReader
import rasterlab.grader.rules.CourseExercises
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.storage.makeOwnerOnly
import rasterlab.grader.submission.Marks
import java.io.IOException
import java.nio.file.AccessDeniedException
import java.nio.file.Files
import java.nio.file.Path
import java.time.InstantSource
import java.util.concurrent.Callable
import kotlin.io.path.absolute
import kotlin.io.path.exists
import kotlin.io.path.isDirectory

/** The file that something is written to. */
internal class OutputOptions {
    @Option(
        names = ["--to"],
        paramLabel = "FILE",
        descriptionKey = "export.to",
        description = ["Where to; must not be there yet. Default: standard output."],
    )
    var to: Path? = null

    /** @throws CannotStart where the file is there, or its folder is not */
    fun requireNew() {
        val file = to ?: return
        if (file.exists()) throw CannotStart(StartFailure.EXPORT_THERE, file)
        val folder = file.absolute().normalize().parent
        if (!folder.isDirectory()) throw CannotStart(StartFailure.EXPORT_FOLDER, file, folder)
    }

    /** Writes to the file, which nobody but its owner reads, or to standard output. */
    fun write(
        spec: CommandSpec,
        bytes: ByteArray,
    ) {
        val file = to
        if (file == null) {
            val out = spec.commandLine().out
            out.print(bytes.decodeToString())
            out.flush()
            return
        }
        try {
            makeOwnerOnly(file)
            Files.write(file, bytes)
        } catch (denied: AccessDeniedException) {
            throw CannotStart(StartFailure.EXPORT_DENIED, file, cause = denied)
        } catch (failure: IOException) {
            throw CannotStart(StartFailure.EXPORT_FAILED, file, failure.message.orEmpty(), cause = failure)
        }
    }
}

/** Who reads the marks of which course, and by which exercises. */
internal class MarksOptions {
    @Mixin
    lateinit var options: CourseOptions

    @Option(
        names = ["--for"],
        paramLabel = "READER",
        descriptionKey = "course.for",
        description = ["Who reads it: people, moodle or canvas; default: \${DEFAULT-VALUE}."],
    )
    var reader = GradesReader.PEOPLE

    @Mixin
    lateinit var catalogue: CatalogueOptions

    /**
     * The marks as CSV.
     *
     * @param language of the exercises' titles
     */
    fun read(language: String): String =
        options.open { database, courses: Courses ->
            courses.find(options.course) ?: throw options.unknown()
            val exercises = Exercises(catalogue.read().all())
            val chosen = CourseExercises(database, exercises.all.map { it.id() }, InstantSource.system())
            Grades(courses, Marks(database), exercises, chosen).of(options.course, reader, language)
        }
}

/** Writes the marks of a course to a file, on the server's machine; the server may run meanwhile. */
@Command(
    name = "export",
    mixinStandardHelpOptions = true,
    description = [
        "Writes the marks of a course as CSV: as people read it, or as Moodle or Canvas take it back.",
        "Titles of exercises are in the language of --lang.",
    ],
)
internal class ExportCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var marks: MarksOptions

    @Mixin
    lateinit var output: OutputOptions

    override fun call(): Int {
        output.requireNew()
        output.write(spec, marks.read(words.language.language).toByteArray())
        return 0
    }
}
