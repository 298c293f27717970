package rasterlab.grader.report

import com.fasterxml.jackson.dataformat.csv.CsvGenerator
import com.fasterxml.jackson.dataformat.csv.CsvMapper
import com.fasterxml.jackson.dataformat.csv.CsvSchema
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Enrolled

/** Who reads a file of marks. */
enum class GradesReader {
    PEOPLE,
    MOODLE,
    CANVAS,
    ;

    /** Lower-case, as in the HTTP API. */
    val code get() = name.lowercase()

    override fun toString() = code
}

/** A student's line of a file of marks. */
class GradesLine(
    val student: Enrolled,
    val fields: Map<String, String>,
    val points: Map<String, Int>,
)

/**
 * The marks of a course as CSV, in the columns that its reader expects. A cell that a spreadsheet would take for a
 * formula begins with an apostrophe.
 *
 * @param language of the exercises' titles
 */
class GradesFile(
    private val exercises: List<Exercise>,
    private val language: String,
) {
    fun write(
        reader: GradesReader,
        lines: List<GradesLine>,
    ): String {
        val inOrder = lines.sortedBy { it.student.number }
        val table =
            when (reader) {
                GradesReader.PEOPLE -> forPeople(inOrder)
                GradesReader.MOODLE -> forMoodle(inOrder)
                GradesReader.CANVAS -> forCanvas(inOrder)
            }
        return csv
            .writer(
                CsvSchema.emptySchema().withLineSeparator("\r\n"),
            ).writeValueAsString(table.map { it.map(::safe) })
    }

    private fun forPeople(lines: List<GradesLine>) =
        listOf(listOf("number", "name") + exercises.map { it.id() } + "total") +
            lines.map { line ->
                listOf("${line.student.number}", line.student.shownName) + marks(line) + "${line.points.values.sum()}"
            }

    /** Moodle finds the student by whichever of these the instructor chooses; only those are there that are known. */
    private fun forMoodle(lines: List<GradesLine>): List<List<String>> {
        val known = MOODLE.filter { (kind, _) -> lines.any { kind in it.fields } }
        val head = known.map { it.second } + "Full name" + titles()
        return listOf(head) +
            lines.map { line ->
                known.map { (kind, _) -> line.fields[kind].orEmpty() } + line.student.shownName + marks(line)
            }
    }

    /** Canvas takes its own five columns, a second line with what could be had, and a column for each assignment. */
    private fun forCanvas(lines: List<GradesLine>): List<List<String>> {
        val possible = listOf("    Points Possible", "", "", "", "") + exercises.map { "${it.points().total()}" }
        return listOf(listOf("Student") + CANVAS.map { it.second } + titles(), possible) +
            lines.map { line ->
                val name = line.fields["canvas-student"] ?: line.student.shownName
                listOf(name) + CANVAS.map { (kind, _) -> line.fields[kind].orEmpty() } + marks(line)
            }
    }

    private fun titles() = exercises.map { it.title(language) }

    private fun marks(line: GradesLine) = exercises.map { line.points[it.id()]?.toString().orEmpty() }

    private companion object {
        val csv: CsvMapper = CsvMapper().apply { enable(CsvGenerator.Feature.STRICT_CHECK_FOR_QUOTING) }

        val MOODLE = listOf("username" to "Username", "id-number" to "ID number", "email" to "Email address")

        val CANVAS =
            listOf(
                "canvas-id" to "ID",
                "sis-user-id" to "SIS User ID",
                "sis-login-id" to "SIS Login ID",
                "section" to "Section",
            )

        fun safe(cell: String) = if (cell.isNotEmpty() && cell[0] in "=+-@\t\r") "'$cell" else cell
    }
}
