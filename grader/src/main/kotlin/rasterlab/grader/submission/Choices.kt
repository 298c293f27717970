package rasterlab.grader.submission

import rasterlab.grader.course.Identity
import rasterlab.grader.problem.Rejection
import rasterlab.grader.rules.CountingPolicy
import rasterlab.grader.rules.CourseRules
import rasterlab.grader.storage.Database

/** Lets students say which of their submissions counts, where the course leaves that to them. */
class Choices(
    private val database: Database,
) {
    /**
     * Makes the submission the one that counts.
     *
     * @throws Rejection.NothingToChoose where the course rules otherwise
     */
    fun choose(
        student: Identity.StudentIdentity,
        id: String,
    ): Submission =
        database.write { handle ->
            val chosen =
                Submissions.find(handle, id)?.takeIf { it.student == student.id }
                    ?: throw Rejection.UnknownSubmission(id)
            val policy = CourseRules.of(handle, student.id, chosen.exercise).policy
            if (policy != CountingPolicy.CHOSEN) throw Rejection.NothingToChoose(chosen.exercise, policy.code)
            handle
                .createUpdate(
                    """UPDATE submissions SET is_chosen = CASE WHEN id = :id THEN 1 ELSE 0 END
                       WHERE student_id = :student AND exercise = :exercise""",
                ).bind("id", id)
                .bind("student", student.id)
                .bind("exercise", chosen.exercise)
                .execute()
            chosen
        }
}
