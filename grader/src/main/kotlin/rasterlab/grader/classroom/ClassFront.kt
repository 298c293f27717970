package rasterlab.grader.classroom

import rasterlab.engine.study.measuring.MedianInterval
import rasterlab.exercises.Exercise
import rasterlab.grader.storage.Database
import rasterlab.grader.submission.around
import rasterlab.grader.submission.error

/**
 * A student's place on the chart of speed and accuracy.
 *
 * @param ratio of the time to that of the reference, which was measured in the same run on the same machine
 * @param error may be infinite
 * @param named whether the student wants the class to read the name
 */
data class FrontPoint(
    val student: String,
    val name: String,
    val submission: String,
    val ratio: MedianInterval,
    val error: Double,
    val named: Boolean,
)

/** Reads the speeds and errors of a class. */
class ClassFront(
    private val database: Database,
) {
    /**
     * The places of a course's last results for the exercise as it is now, the quickest first; other revisions have
     * other inputs, so that their times are not compared.
     */
    fun of(
        course: String,
        exercise: Exercise,
    ): List<FrontPoint> =
        database.read { handle ->
            handle
                .last(
                    course,
                    exercise.id(),
                    "students.id AS student, students.shown_name, students.named_on_front, last.id AS submission, measured.*",
                    """JOIN students ON students.id = last.student_id
                       JOIN results AS measured ON measured.id = last.result""",
                    """AND measured.revision = :revision
                       AND measured.reference_nanos > 0 AND measured.nanos_per_item > 0""",
                ).bind("revision", exercise.revision())
                .map { row, _ ->
                    FrontPoint(
                        row.getString("student"),
                        row.getString("shown_name"),
                        row.getString("submission"),
                        row.around(row.getDouble("nanos_per_item") / row.getDouble("reference_nanos")),
                        row.error(),
                        row.getInt("named_on_front") == 1,
                    )
                }.list()
                .sortedWith(compareBy({ it.ratio.median() }, { it.error }))
        }

    /**
     * Returns all places where there are enough without a name for a student to hide among, else only the own one and
     * those with a name.
     */
    fun seenBy(
        student: String,
        course: String,
        exercise: Exercise,
    ): List<FrontPoint> {
        val all = of(course, exercise)
        val hidden = all.count { !it.named }
        return if (hidden < LEAST) all.filter { it.student == student || it.named } else all
    }

    /** Whether the class reads the student's name on its charts. */
    fun names(student: String): Boolean =
        database.read {
            it
                .createQuery("SELECT named_on_front FROM students WHERE id = :student")
                .bind("student", student)
                .mapTo(Int::class.javaObjectType)
                .one() == 1
        }

    /** Lets the class read the student's name on its charts, or no longer. */
    fun name(
        student: String,
        named: Boolean,
    ) {
        database.write {
            it
                .createUpdate("UPDATE students SET named_on_front = :named WHERE id = :student")
                .bind("named", if (named) 1 else 0)
                .bind("student", student)
                .execute()
        }
    }

    companion object {
        /** Points without a name from which on a student is shown those of the others: of fewer it could be told whose they are. */
        const val LEAST = 5
    }
}
