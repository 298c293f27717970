package rasterlab.grader.submission

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Exercise
import rasterlab.grader.Classroom
import rasterlab.grader.json
import rasterlab.grader.text
import java.nio.file.Path
import java.util.concurrent.CopyOnWriteArrayList

/** An exercise is changed while the server stands still. */
class RevisionTest {
    @TempDir
    lateinit var folder: Path
    private val against = CopyOnWriteArrayList<String>()

    @Test
    @DisplayName("what was handed in before is graded against the new exercise, or its result looks like a current one")
    fun whatWasHandedInBeforeGoesByItsOwnRevision() {
        var student = ""
        var before = ""
        Classroom(folder).open(grades = false) {
            student = newStudent()
            before = submit(student).json().text("id")
        }
        changed().open {
            eventsToTheEnd(student, before)
            val after = submit(student).json().text("id")
            eventsToTheEnd(student, after)
            assertEquals(listOf("r1", "r2"), against)
            val told =
                listOf(before, after).map {
                    val view = look(student, "/api/v1/submissions/$it").json()
                    view.text("revision") to view.text("current")
                }
            assertEquals(listOf("r1" to "false", "r2" to "true"), told)
        }
    }

    @Test
    @DisplayName("the pages do not say that a result is of an earlier exercise")
    fun thePagesSayWhichOfTheResultsIsOfAnEarlierExercise() {
        var student = ""
        var before = ""
        Classroom(folder).open {
            student = newStudent()
            before = submit(student).json().text("id")
            eventsToTheEnd(student, before)
        }
        changed().open {
            val after = submit(student).json().text("id")
            eventsToTheEnd(student, after)
            val session = rasterlab.grader.course.Accounts(database) { java.time.Instant.now() }
            val cookie = "rasterlab=${session.open(checkNotNull(session.holder(student)))}"
            val page: suspend (String) -> String = {
                client.get(it) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
            }
            val words = "The exercise has changed since"
            assertEquals(listOf(true, false), listOf(before, after).map { words in page("/submissions/$it") })
            val attempts = page("/exercises/draw-dot")
            assertEquals(2, attempts.split("earlier version of the exercise").size, attempts)
        }
    }

    /** A classroom with the exercise of before kept. */
    private fun changed() =
        Classroom(
            folder,
            { exercise, _, _, _ -> Classroom.wrongReport().also { against += exercise.revision() } },
            exercise = Classroom.EXERCISE.at("r2"),
            kept = { _, revision -> Classroom.EXERCISE.takeIf { it.revision() == revision } },
        ).also { assertTrue(Classroom.EXERCISE.revision() == "r1") }

    private fun Exercise.at(revision: String) =
        Exercise(
            id(),
            topic(),
            title(),
            statement(),
            pictures(),
            starter(),
            revision,
            tolerance(),
            points(),
            cases(),
        )
}
