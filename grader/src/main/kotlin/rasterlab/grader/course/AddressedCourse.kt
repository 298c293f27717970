package rasterlab.grader.course

import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import kotlin.jvm.optionals.getOrNull

/**
 * A thing that an address names, with what it belongs to.
 *
 * @param course the id of its course; null where there is no such thing
 * @param missing tells that it is not there
 */
internal class Addressed(
    val course: String?,
    val missing: Rejection,
)

/** Knows of which course the thing is that an address names, be it one of the API or of a page. */
class AddressedCourse(
    private val database: Database,
) {
    /** The thing that the address names; null where it names none that is of a course. */
    internal fun of(parts: List<String>): Addressed? {
        val place = within(parts)
        val known = KINDS[place.firstOrNull()] ?: return null
        val id = place.getOrNull(1) ?: return null
        val found =
            database.read {
                it
                    .createQuery(known.course)
                    .bind("id", id)
                    .mapTo(String::class.java)
                    .findOne()
            }
        return Addressed(found.getOrNull(), known.missing(id))
    }

    /** @param course selects the id of its course */
    private class Kind(
        val course: String,
        val missing: (String) -> Rejection,
    )

    internal companion object {
        private val API = listOf("api", "v1")
        const val DESK = "instructor"

        /** The address without what leads to the API, or to the desk of staff. */
        fun within(parts: List<String>): List<String> {
            val place = withoutApi(parts)
            return if (place.firstOrNull() == DESK) place.drop(1) else place
        }

        fun withoutApi(parts: List<String>): List<String> =
            if (parts.take(API.size) == API) parts.drop(API.size) else parts

        private const val OF_STUDENT = "SELECT course_id FROM students WHERE id ="

        private val KINDS =
            mapOf(
                "courses" to
                    Kind("SELECT id FROM courses WHERE id = :id OR code = upper(trim(:id))", Rejection::UnknownCourse),
                "students" to Kind("$OF_STUDENT :id", Rejection::UnknownStudent),
                "submissions" to
                    Kind(
                        "$OF_STUDENT (SELECT student_id FROM submissions WHERE id = :id)",
                        Rejection::UnknownSubmission,
                    ),
                "trials" to
                    Kind(
                        """$OF_STUDENT (SELECT student_id FROM submissions
                           WHERE id = (SELECT submission_id FROM trials WHERE id = :id))""",
                        Rejection::UnknownTrial,
                    ),
                "exams" to Kind("SELECT course_id FROM exams WHERE id = :id", Rejection::UnknownExam),
                "regrades" to Kind("SELECT course_id FROM regrades WHERE id = :id", Rejection::UnknownRegrade),
            )
    }
}
