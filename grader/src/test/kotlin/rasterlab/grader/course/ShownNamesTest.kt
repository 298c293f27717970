package rasterlab.grader.course

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.student.StudentRecords
import java.nio.file.Path
import java.time.InstantSource

/** Students of one name are told apart. */
@Tag("slow")
class ShownNamesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a newcomer, or a roster's, gets the number of somebody who was deleted")
    fun noNumberIsGivenTwice() =
        TestDatabases.open(folder).use { database ->
            val clock = InstantSource.system()
            val courses = Courses(database, clock)
            val course = courses.create(by = "i", Name.of("Graphics"), key = null)
            val join = { name: String -> courses.join(course.code, Name.of(name), key = null) }
            val delete = { student: String -> StudentRecords(database, clock).delete(student, by = "i") }
            join("Ada")
            delete(join("Eve").id)
            delete(join("Eve").id)
            val roster = "Name\nAda\nGrace\nAda King\n".toByteArray()
            val rows = RosterImport(database, clock).apply(course, roster, dry = false, by = "i", key = null)
            delete(checkNotNull(rows.added.last().student))
            join("Alan")
            assertEquals(
                listOf("1 Ada", "4 Grace", "6 Alan"),
                courses.students(course.id)?.map { "${it.number} ${it.name}" }?.sorted(),
            )
        }

    @Test
    @DisplayName("two students of a course are shown under one name, or numbers go on from another course")
    fun noTwoAreShownUnderOneName() =
        TestDatabases.open(folder).use { database ->
            val courses = Courses(database, InstantSource.system())
            val names = listOf("Ada", "Ada", "Ada (2)", "Grace")
            for (title in listOf("Graphics", "Geometry")) {
                val course = courses.create(by = "i", Name.of(title), key = null)
                names.forEach { courses.join(course.code, Name.of(it), key = null) }
                assertEquals(
                    listOf("1 Ada", "2 Ada (2)", "3 Ada (2) (3)", "4 Grace"),
                    courses.students(course.id)?.map { "${it.number} ${it.shownName}" },
                )
            }
        }
}
