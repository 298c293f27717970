// Who may do what: courses, students, the instructor, tokens and sessions. Start with Identity.
package rasterlab.grader.course

import io.ktor.server.application.ApplicationCall
import io.ktor.server.auth.principal
import rasterlab.grader.problem.Rejection

/** Who asks. */
sealed interface Identity {
    val id: String

    data class Instructor(
        override val id: String,
    ) : Identity

    data class Student(
        override val id: String,
        val name: String,
        val course: String,
    ) : Identity
}

/** Who asks, inside `authenticate`. */
fun ApplicationCall.identity(): Identity = principal<Identity>() ?: throw Rejection.NotSignedIn()

fun ApplicationCall.student(): Identity.Student =
    identity() as? Identity.Student ?: throw Rejection.WrongRole("student")

fun ApplicationCall.instructor(): Identity.Instructor =
    identity() as? Identity.Instructor ?: throw Rejection.WrongRole("instructor")
