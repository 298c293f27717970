package rasterlab.grader.storage

import io.ktor.client.request.get
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpStatusCode
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeout
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.json
import rasterlab.grader.postgres.OnPostgres
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.text
import java.nio.file.Path
import kotlin.time.Duration.Companion.minutes

/** PostgreSQL is killed and started again while a server runs. */
@OnPostgres
@Tag("slow")
class LostDatabaseTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a server whose database was away says that it is ready, or has to be started again")
    fun goesOnWhenTheDatabaseIsBack() =
        Classroom(folder).open {
            val student = newStudent()
            val before = submit(student).json().text("id")
            eventsToTheEnd(student, before)
            checkNotNull(TestDatabases.server).restart {
                runBlocking { client.get("/readyz").assertProblem(503, "storage") }
            }
            withTimeout(1.minutes) { while (!isReady()) continue }
            val after = submit(student).json().text("id")
            for (id in listOf(before, after)) assertEquals("done", eventsToTheEnd(student, id).last().first)
            assertTrue("wrong" in look(student, "/api/v1/submissions/$after").bodyAsText())
        }

    private suspend fun Visit.isReady() = client.get("/readyz").status == HttpStatusCode.OK
}
