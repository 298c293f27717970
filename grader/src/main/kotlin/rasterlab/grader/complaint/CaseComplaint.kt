/*
 * A student's complaint against the result for one case, and what staff answer.
 * Read CaseComplaint, ComplaintDesk, ComplaintRows, ComplaintRoutes, in this order.
 */
package rasterlab.grader.complaint

import rasterlab.grader.regrade.RegradeState
import java.time.Instant

enum class ComplaintState {
    OPEN,
    ACCEPTED,
    DECLINED,
    ;

    /** Lower-case, as stored and in the HTTP API. */
    val code get() = name.lowercase()
}

/**
 * The words with which staff settled a complaint.
 *
 * @param name of who answered; empty for the first instructor, whom nobody named
 * @param role of who answered: instructor or assistant
 */
data class ComplaintAnswer(
    val text: String,
    val name: String,
    val role: String,
    val at: Instant,
)

/** The regrade of the one submission that an answer began, and how far it is. */
data class ComplaintRegrade(
    val id: String,
    val state: RegradeState,
)

/**
 * The words of a student against the result for one case.
 *
 * @param case name of the case in the exercise
 * @param current whether it is about the result that counts now
 * @param answer null as long as nobody answered
 * @param regrade null where none was begun for it
 */
data class CaseComplaint(
    val id: String,
    val submission: String,
    val case: String,
    val current: Boolean,
    val text: String,
    val openedAt: Instant,
    val state: ComplaintState,
    val answer: ComplaintAnswer?,
    val regrade: ComplaintRegrade?,
)

/**
 * A complaint in the list of a course.
 *
 * @param student the name that the course shows
 */
data class ListedComplaint(
    val complaint: CaseComplaint,
    val student: String,
    val exercise: String,
    val attempt: Int,
)
