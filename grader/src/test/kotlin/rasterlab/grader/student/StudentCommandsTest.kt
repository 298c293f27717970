package rasterlab.grader.student

import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import picocli.CommandLine
import rasterlab.exercises.Exercise
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.grader.Classroom
import rasterlab.grader.CommandWords
import rasterlab.grader.Visit
import rasterlab.grader.bearer
import rasterlab.grader.commandLine
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.printedBy
import java.nio.file.Path
import java.util.zip.ZipInputStream
import kotlin.io.path.exists
import kotlin.io.path.getPosixFilePermissions
import kotlin.io.path.inputStream
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** Commands on the server's machine reach students and marks without a token. */
@Tag("slow")
class StudentCommandsTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a list or a student is told in another way than by HTTP, or somebody of another course is listed")
    fun studentsAreListedAndShown() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            newStudent()
            val ada = rostered(course)
            val eve = one("SELECT id FROM students WHERE name = 'Eve'")
            assertEquals(
                listOf("$ada\t1\t17\tada@example.org\tAda", "$eve\t2\t-\t-\tEve"),
                student("list", course).trim().lines(),
            )
            val told = look(instructor, "/api/v1/courses/$course/students").bodyAsText()
            assertEquals(Json.parseToJsonElement(told), Json.parseToJsonElement(student("list", course, "--json")))
            val shown =
                student("show", ada).trim().lines().associate {
                    it.substringBefore("\t") to
                        it.substringAfter("\t")
                }
            assertEquals(
                listOf(course, "1", "Ada", "17", "ada@example.org", "0"),
                listOf("course", "number", "name", "id-number", "email", "submissions").map(shown::get),
            )
            val one = look(instructor, "/api/v1/courses/$course/students/$ada").json()
            assertEquals(one, Json.parseToJsonElement(student("show", ada, "--json")))
            assertTrue("'none'" in student("show", "none", exit = 2))
            assertTrue("none" in student("list", "none", exit = 2))
        }

    @Test
    @DisplayName("an export is another document than by HTTP, is not noted, or takes the place of a file")
    fun aStudentIsExported() =
        Classroom(folder, exercise = Classroom.another("line-bresenham")).open(grades = false) {
            submit(newStudent(), exercise = "line-bresenham")
            val id = one("SELECT id FROM students")
            val told = look(instructor, "/api/v1/students/$id/export").json()
            assertEquals(told, Json.parseToJsonElement(student("export", id)))
            assertEquals("2", one("SELECT count(*) FROM audit WHERE action = 'export' AND subject = '$id'"))
            val zip = folder.resolve("ada.zip")
            assertTrue("--to" in student("export", id, "--as", "zip", exit = 2))
            student("export", id, "--as", "zip", "--to", "$zip")
            val names = ZipInputStream(zip.inputStream()).use { generateSequence { it.nextEntry?.name }.toList() }
            assertEquals(listOf("student.json", "line-bresenham/attempt-1.java"), names)
            if ("posix" in zip.fileSystem.supportedFileAttributeViews()) {
                assertEquals(2, zip.getPosixFilePermissions().size, "others read it")
            }
            assertTrue("already" in student("export", id, "--to", "$zip", exit = 2))
            val absent = folder.resolve("none.json")
            student("export", "none", "--to", "$absent", exit = 2)
            assertFalse(absent.exists(), "a file is left behind")
            val nowhere = folder.resolve("none/a")
            val refused = student("export", id, "--to", "$nowhere", exit = 2)
            assertTrue("no folder ${nowhere.parent}" in refused && "Exception" !in refused, refused)
            assertEquals("3", one("SELECT count(*) FROM audit WHERE action = 'export' AND subject = '$id'"))
        }

    @Test
    @DisplayName("a student is deleted unasked, stays when it is asked for, or takes another along")
    fun aStudentIsDeleted() =
        Classroom(folder).open(grades = false) {
            val (token, other) = List(2) { newStudent() }
            submit(token)
            val id = one("SELECT student_id FROM submissions")
            val refused = student("delete", id, exit = 2)
            assertTrue("Ada" in refused && "(1)" in refused && "--yes" in refused, refused)
            assertTrue("навсегда" in student("delete", id, "--lang", "ru", exit = 2))
            assertEquals("2", one("SELECT count(*) FROM students"))
            assertEquals("deleted\t$id\nsubmissions\t1", student("delete", id, "--yes").trim())
            assertEquals(401, look(token, "/api/v1/exercises").status.value)
            assertEquals(200, look(other, "/api/v1/exercises").status.value)
            assertEquals("0", one("SELECT count(*) FROM submissions"))
            assertEquals("command", one("SELECT account_id FROM audit WHERE action = 'delete'"))
            student("delete", id, "--yes", exit = 2)
        }

    @Test
    @DisplayName("marks are not those of the page, a form is missing, or a file is overwritten")
    fun marksAreExported() =
        Classroom(folder, exercise = BUILT_IN.first(), more = BUILT_IN.drop(1)).open(grades = false) {
            val course = newCourse()
            rostered(course)
            val file = folder.resolve("marks.csv")
            for (reader in listOf("people", "moodle", "canvas")) {
                val told = look(instructor, "/api/v1/courses/$course/grades.csv?for=$reader&lang=ru").bodyAsText()
                assertEquals(told, marks(course, "--for", reader, "--lang", "ru"))
            }
            marks(course, "--for", "moodle", "--to", "$file")
            assertEquals(
                look(instructor, "/api/v1/courses/$course/grades.csv?for=moodle&lang=en").bodyAsText(),
                file.readText(),
            )
            file.writeText("mine")
            assertTrue("already" in marks(course, "--to", "$file", exit = 2))
            assertEquals("mine", file.readText())
            assertTrue("none" in marks("none", exit = 2))
            assertTrue("people, moodle, canvas" in marks(course, "--for", "excel", exit = 2))
        }

    @Test
    @DisplayName("a list of commands breaks off in a sentence, or a default is told in other letters than it is typed")
    fun helpIsWholeAndAsTyped() {
        for (language in listOf("en", "ru")) {
            for (command in below(commandLine(CommandWords.asked("--lang", language))).map { it.commandSpec }) {
                val first =
                    command
                        .usageMessage()
                        .description()
                        .firstOrNull()
                        .orEmpty()
                assertTrue(first.endsWith("."), "$language ${command.qualifiedName()}: $first")
                val defaults = command.options().filter { it.type().isEnum }.mapNotNull { it.defaultValueString() }
                assertEquals(defaults.map { it.lowercase() }, defaults, command.qualifiedName())
            }
        }
    }

    private fun below(command: CommandLine): List<CommandLine> =
        listOf(command) + command.subcommands.values.flatMap(::below)

    @Test
    @DisplayName("a correction tells a name that stays as a change, or a field by a name that only programs use")
    fun aRosterIsToldInWords() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            rostered(course)
            val file = folder.resolve("roster.csv")
            file.writeText("Name,ID number,Email,Section,Login\nAda King,17,ada@example.org,B,\nEve,,,A,eve\n")
            val told =
                listOf("en", "ru").map { language ->
                    val roster = arrayOf("course", "roster", course, "$file", "--dry-run", "--lang", language)
                    printedBy(folder, *roster).trim().lines().filter { "->" in it || "Eve" in it }
                }
            val changes = listOf("  section: - -> B", "corrected: Eve", "  section: - -> A", "  username: - -> eve")
            assertEquals(listOf("corrected: Ada -> Ada King") + changes, told[0])
            assertEquals(
                listOf("исправлено: Eve", "  группа: - -> A", "  логин: - -> eve"),
                told[1].drop(2),
            )
        }

    /** The id of the first of two students whom a roster brings. */
    private suspend fun Visit.rostered(course: String): String =
        client
            .post("/api/v1/courses/$course/roster") {
                bearer(instructor)
                header(HttpHeaders.ContentType, "text/csv")
                setBody("Name,ID number,Email\nAda,17,ada@example.org\nEve,,\n")
            }.json()
            .list("added")
            .first()
            .field("student")

    private fun student(
        vararg arguments: String,
        exit: Int = 0,
    ) = printedBy(folder, "student", *arguments, exit = exit)

    private fun marks(
        vararg arguments: String,
        exit: Int = 0,
    ) = printedBy(folder, "export", *arguments, exit = exit)

    private companion object {
        val BUILT_IN: List<Exercise> = Catalogue.builtIn().all()
    }
}
