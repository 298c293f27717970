package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.grader.storage.Database
import java.time.Duration
import java.time.Instant
import kotlin.math.ceil

/**
 * Where a submission stands in the queue.
 *
 * @param position 1 for the next one to be graded; 0 when it does not wait
 * @param waitSeconds until it is graded, as estimated; null when it does not wait, or nothing is known
 */
class QueuePlace(
    val position: Int,
    val waitSeconds: Int?,
) {
    companion object {
        val NONE = QueuePlace(0, null)

        /** The latest results that tell the pace. */
        private const val LATEST = 20

        /** Reads where the submission of that id stands. */
        fun of(
            database: Database,
            id: String,
        ): QueuePlace =
            database.read { handle ->
                val position = Submissions.position(handle, id)
                QueuePlace(position, secondsEach(handle)?.takeIf { position > 0 }?.let { ceil(position * it).toInt() })
            }

        /**
         * The median of the seconds that the latest results took, whoever graded them: from the result before, or from
         * when it was handed in where nothing was graded then.
         */
        private fun secondsEach(handle: Handle): Double? {
            val ends =
                handle
                    .createQuery(
                        """SELECT graded_at, received_at FROM results JOIN submissions ON submissions.id = submission_id
                           WHERE run = 1 ORDER BY graded_at DESC LIMIT ${LATEST + 1}""",
                    ).map { row, _ -> Instant.parse(row.getString(1)) to Instant.parse(row.getString(2)) }
                    .list()
            val took =
                ends
                    .zipWithNext {
                        (graded, received),
                        (before, _),
                        ->
                        Duration.between(maxOf(received, before), graded)
                    }.filter { it > Duration.ZERO }
                    .sorted()
            return if (took.isEmpty()) null else took[took.size / 2].toMillis() / 1e3
        }
    }
}
