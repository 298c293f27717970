package rasterlab.grader.worker

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.postgres.OnPostgres
import rasterlab.grader.postgres.TestDatabases
import java.nio.file.Path
import kotlin.random.Random

/**
 * Two servers and three workers on one database. They, the processes that run sources and the database are killed at
 * random and started again. More than the build tries, for which the limits of time have to go: -Drasterlab.kills=200
 * -Drasterlab.students=3 -Djunit.jupiter.execution.timeout.mode=disabled -Dsurefire.timeout=0.
 */
@OnPostgres
@Tag("slow")
class ManyProcessesTest {
    @TempDir
    lateinit var folder: Path
    private val names = listOf("server-a", "server-b", "worker-a", "worker-b", "worker-c")

    @Test
    @DisplayName("a submission is lost, or has two results, when processes are killed")
    fun gradesEachOnceUnderKills() {
        val seed = System.getProperty("rasterlab.seed")?.toLong() ?: System.nanoTime()
        println("seed $seed")
        val random = Random(seed)
        SharedCourse(folder, "many").use { course ->
            val running = names.associateWithTo(HashMap()) { start(course, it) }
            val students = List(STUDENTS) { course.student("Student $it") }
            repeat(KILLS) { kill ->
                students.forEach { course.handIn(it) }
                val enough = done(course) + 1 + random.nextInt(STUDENTS / 2)
                course.await("expected results to come") { done(course) >= enough }
                val name = names.random(random)
                val process = checkNotNull(running[name])
                if (kill % EACH == EACH / 2) restart(course)
                if (random.nextInt(CHILD_KILLS) == 0) {
                    process.killChild(random)
                } else {
                    process.kill()
                    running[name] = start(course, name)
                }
            }
            course.awaitAllDone()
            course.requireEachOnce()
            assertEquals("${KILLS * STUDENTS}", course.rows("SELECT count(*) FROM results").single())
        }
    }

    /** The test's own connections are lost, too; one that is fails once. */
    private fun restart(course: SharedCourse) {
        checkNotNull(TestDatabases.server).restart {}
        course.await("expected the database to be back") { runCatching { done(course) }.isSuccess }
    }

    private fun done(course: SharedCourse) =
        course.rows("SELECT count(*) FROM submissions WHERE state = 'done'").single().toInt()

    private fun start(
        course: SharedCourse,
        name: String,
    ): GraderProcess = if (name.startsWith("server")) course.server(name) else course.worker(name)

    private companion object {
        val STUDENTS = Integer.getInteger("rasterlab.students", 4)
        val KILLS = Integer.getInteger("rasterlab.kills", 6)

        /** The database is started again once in so many kills. */
        const val EACH = 6

        /** The kills for each one of a process that runs sources. */
        const val CHILD_KILLS = 3
    }
}
