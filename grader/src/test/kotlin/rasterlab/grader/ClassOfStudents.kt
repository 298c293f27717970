package rasterlab.grader

import rasterlab.exercises.Exercise
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.limits.IntakeLimits
import rasterlab.grader.storage.Database
import rasterlab.grader.submission.Intake
import java.time.InstantSource

/** Students of one course who hand in, without a server. */
class ClassOfStudents(
    private val database: Database,
    private val clock: InstantSource,
    private val exercise: Exercise = Classroom.EXERCISE,
) {
    private val courses = Courses(database, clock)
    private val intake = Intake(database, IntakeLimits(), clock)
    private val course = courses.create(by = "i", Name.of("Graphics"), key = null)

    fun student(name: String): Identity.StudentIdentity {
        val token = courses.join(course.code, Name.of(name), key = null).token
        return Accounts(database, clock).holder(token) as Identity.StudentIdentity
    }

    /** Hands [source] in and returns the submission's id. */
    fun handIn(
        student: Identity.StudentIdentity,
        source: String = "class Dot {}",
    ): String = intake.accept(student, exercise, source, key = null).id
}
