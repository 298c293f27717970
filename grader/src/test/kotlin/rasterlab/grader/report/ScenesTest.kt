package rasterlab.grader.report

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Exercise
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.json
import rasterlab.grader.text
import java.nio.file.Path

/** The way from a failed case to the lab. */
class ScenesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun anOpenCaseIsSavedUnderTheNameThatTheCommandTakes() =
        graded { token, id ->
            val scene = look(token, "/api/v1/submissions/$id/cases/open-case/scene.json")
            assertEquals(200, scene.status.value)
            assertEquals("""{"from":[0,0],"to":[3,1]}""", scene.bodyAsText())
            assertEquals("draw-dot-1-open-case.scene.json", savedAs(scene))
            val source = look(token, "/api/v1/submissions/$id/source")
            assertEquals("class Dot {}", source.bodyAsText())
            assertEquals("draw-dot-1.java", savedAs(source))
            assertTrue(source.headers[HttpHeaders.ContentType].orEmpty().startsWith("text/x-java-source"))
        }

    @Test
    fun aHiddenCaseIsNoFileForStudents() =
        graded { token, id ->
            val hidden = "/api/v1/submissions/$id/cases/hidden-case/scene.json"
            look(token, hidden).assertProblem(404, "unknown-scene")
            assertEquals(200, look(instructor, hidden).status.value)
            look(token, "/api/v1/submissions/$id/cases/none/scene.json").assertProblem(404, "unknown-scene")
        }

    @Test
    fun whatIsAnothersIsNotThere() =
        graded { token, id ->
            val other = newStudent()
            for (file in listOf("source", "cases/open-case/scene.json")) {
                look(other, "/api/v1/submissions/$id/$file").assertProblem(404, "unknown-submission")
                client.get("/api/v1/submissions/$id/$file").assertProblem(401, "not-signed-in")
                assertEquals(200, look(token, "/api/v1/submissions/$id/$file").status.value)
            }
        }

    @Test
    fun thePageOffersTheFilesOfOpenCasesAloneWithTheCommand() =
        graded { token, id ->
            val cookie = session(token)
            for ((language, title) in listOf("en" to "Open in the lab", "ru" to "Открыть в лаборатории")) {
                val page =
                    client
                        .get(
                            "/submissions/$id?lang=$language",
                        ) { header(HttpHeaders.Cookie, cookie) }
                        .bodyAsText()
                assertEquals(1, Regex("<summary>$title</summary>").findAll(page).count(), page)
                assertTrue("""href="/api/v1/submissions/$id/cases/open-case/scene.json"""" in page, page)
                assertTrue("""href="/api/v1/submissions/$id/source"""" in page, page)
                // The lab on a student's machine has no exercise of the course's own.
                val files = "draw-dot-1-open-case.scene.json --exercise line-bresenham --with draw-dot-1.java"
                assertTrue("<code>./lab open $files</code>" in page, page)
                assertTrue(Regex("<p>[^<]*line-bresenham").containsMatchIn(page), page)
                assertFalse("hidden-case.scene.json" in page, page)
            }
        }

    @Test
    fun `the lab is given the name of an exercise that it has`() {
        val line = Catalogue.builtIn().named("line-bresenham")
        assertEquals(InLab.Known, InLab.of(line))
        assertEquals(InLab.Like("line-bresenham"), InLab.of(renamed(line, line.topic())))
        assertEquals(InLab.FromFolder, InLab.of(renamed(line, "line-plane")))
        val files = LabFiles("own", 2, Exercise.TaskKind.WRITE, InLab.FromFolder)
        val opened = "./lab open own-2-a.scene.json --exercises FOLDER --exercise own --with own-2.java"
        assertEquals(opened, files.command("a"))
    }

    private fun renamed(
        one: Exercise,
        topic: String,
    ) = Exercise(
        "own",
        topic,
        one.contract(),
        one.title(),
        one.statement(),
        one.pictures(),
        one.starter(),
        one.revision(),
        one.tolerance(),
        one.points(),
        one.caps(),
        one.timed(),
        one.groups(),
        one.cases(),
        one.breaking(),
        one.predicting(),
        one.evidence(),
        one.minutes(),
        one.hints(),
    )

    private fun savedAs(file: HttpResponse) =
        file.headers[HttpHeaders.ContentDisposition]
            .orEmpty()
            .removePrefix("attachment; filename=")
            .trim('"')

    private suspend fun Visit.session(token: String) =
        client
            .post("/sign-in") {
                header(HttpHeaders.Host, "localhost")
                header(HttpHeaders.Origin, "http://localhost")
                header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
                setBody("token=$token")
            }.headers[HttpHeaders.SetCookie]
            .orEmpty()
            .substringBefore(';')

    /** Runs a test with a student's token and submission. */
    private fun graded(test: suspend Visit.(String, String) -> Unit) =
        Classroom(folder).open {
            val token = newStudent()
            val id = submit(token).json().text("id")
            eventsToTheEnd(token, id)
            test(token, id)
        }
}
