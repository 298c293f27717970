package rasterlab.grader.worker

import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.postgres.OnPostgres
import rasterlab.grader.submission.SharedMoves
import java.nio.file.Path
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit.MILLISECONDS

/** Processes hear of each other's moves. */
@OnPostgres
@Tag("slow")
class SharedMovesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a process does not hear the others, or hears nothing after its connection was lost")
    fun hearsTheOthers() =
        SharedCourse(folder, "moves").use { course ->
            val heard = LinkedBlockingQueue<String>()
            SharedMoves(course.database, "one").use { one ->
                SharedMoves(course.database, "other").use { other ->
                    other.listen { heard += "a move" }
                    course.await("expected the other to hear") { isHeard(one, heard) }
                    course.database.read {
                        it.execute("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE $ELSEWHERE")
                    }
                    heard.clear()
                    course.await("expected the other to hear again") { isHeard(one, heard) }
                }
            }
        }

    /** The other may not listen yet. */
    private fun isHeard(
        one: SharedMoves,
        heard: LinkedBlockingQueue<String>,
    ): Boolean {
        one.tell()
        return heard.poll(LOOK_MILLIS, MILLISECONDS) != null
    }

    private companion object {
        const val LOOK_MILLIS = 100L
        const val ELSEWHERE = "datname = current_database() AND pid <> pg_backend_pid()"
    }
}
