// Who may do what: courses, students, staff, tokens and sessions. Start with Identity.
package rasterlab.grader.course

import io.ktor.server.application.ApplicationCall
import io.ktor.server.auth.principal
import rasterlab.grader.problem.Rejection

/** Who asks. */
sealed interface Identity {
    val id: String

    /** The name that people see; empty for the first instructor, whom nobody named. */
    val name: String

    /** Who teaches, and sees the work of all students with what is hidden from these. */
    sealed interface StaffIdentity : Identity {
        /** The id of the single course that they teach; null for all of the server. */
        val onlyCourse: String?

        fun teaches(course: String): Boolean = onlyCourse == null || onlyCourse == course
    }

    data class Instructor(
        override val id: String,
        override val name: String = "",
        override val onlyCourse: String? = null,
    ) : StaffIdentity

    /** Marks and comments; deletes nothing, takes no data away, and changes no rules, roster, staff or tokens. */
    data class Assistant(
        override val id: String,
        override val name: String,
        override val onlyCourse: String? = null,
    ) : StaffIdentity

    data class StudentIdentity(
        override val id: String,
        override val name: String,
        val course: String,
    ) : Identity
}

/** Who asks, inside `authenticate`. */
fun ApplicationCall.identity(): Identity = principal<Identity>() ?: throw Rejection.NotSignedIn()

fun ApplicationCall.student(): Identity.StudentIdentity =
    identity() as? Identity.StudentIdentity ?: throw Rejection.WrongRole("student")

fun ApplicationCall.staff(): Identity.StaffIdentity =
    identity() as? Identity.StaffIdentity ?: throw Rejection.WrongRole("instructor or assistant")

fun ApplicationCall.instructor(): Identity.Instructor =
    identity() as? Identity.Instructor ?: throw Rejection.WrongRole("instructor")
