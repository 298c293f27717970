package rasterlab.grader.exam

import io.ktor.http.HttpMethod
import io.ktor.server.application.Application
import io.ktor.server.application.ApplicationCall
import io.ktor.server.application.ApplicationCallPipeline
import io.ktor.server.application.call
import io.ktor.server.request.httpMethod
import io.ktor.server.request.path
import io.ktor.server.response.respondRedirect
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.course.addressParts
import rasterlab.grader.course.callers
import rasterlab.grader.course.hasView
import rasterlab.grader.course.sessionCookie
import rasterlab.grader.course.viewedStudent
import rasterlab.grader.forwarding.Forwarding
import rasterlab.grader.problem.HiddenByExam
import rasterlab.grader.problem.Rejection
import rasterlab.grader.submission.Submissions

/**
 * Lets a student who has an exam reach nothing but it, and others nothing that is kept for one, nor an exercise that their
 * course does not have.
 *
 * @param missing the exercises that somebody's course does not have
 */
class ExamGuard(
    private val accounts: Accounts,
    private val sittings: Sittings,
    private val submissions: Submissions,
    private val missing: (Identity) -> Set<String>,
) {
    /** @return whether the call goes on; otherwise it is answered */
    suspend fun pass(call: ApplicationCall): Boolean {
        val parts = call.addressParts()
        // The pages of exams look themselves at who may have which.
        if (parts.firstOrNull() in FREE || parts.firstOrNull() == EXAMS || parts == API + EXAMS) return true
        viewed(call)?.let { refuseKept(it, parts) }
        return accounts.callers(call).filterIsInstance<Identity.StudentIdentity>().all { pass(call, it, parts) }
    }

    private suspend fun pass(
        call: ApplicationCall,
        who: Identity.StudentIdentity,
        parts: List<String>,
    ): Boolean {
        val sitting = sittings.holding(who)
        if (sitting == null) {
            refuseKept(who, parts)
            return true
        }
        if (call.request.httpMethod == HttpMethod.Get && (parts.isEmpty() || parts == listOf("exercises"))) {
            call.respondRedirect("/$EXAMS")
            return false
        }
        if (!belongs(sitting, parts)) throw Rejection.InExam(sitting.exam.name)
        sittings.enter(sitting.exam.id, call.examinee(who))
        return true
    }

    /** The student whose view staff have; it shows no more than the student has. */
    private fun viewed(call: ApplicationCall): Identity.StudentIdentity? {
        if (call.request.path().startsWith("/instructor")) return null
        val session = call.sessionCookie()?.takeIf { call.hasView() } ?: return null
        return accounts.inSession(session)?.let { call.viewedStudent(accounts, it) }
    }

    private fun refuseKept(
        who: Identity.StudentIdentity,
        parts: List<String>,
    ) {
        val kept = sittings.closedTo(who)
        val closed = kept + missing(who)
        parts.firstOrNull(closed::contains)?.let { throw Rejection.UnknownExercise(it) }
        val submission = submissionIn(parts) ?: return
        val found = submissions.find(submission)?.takeIf { it.exercise in kept } ?: return
        throw if (found.student == who.id) HiddenByExam(submission) else Rejection.UnknownSubmission(submission)
    }

    /**
     * Whether a path is a picture or the beginning of one of the exam's exercises, or what was handed in at it; nobody
     * complains, or looks at two versions, before the exam is over.
     */
    private fun belongs(
        sitting: Sitting,
        parts: List<String>,
    ): Boolean {
        val page = if (parts.take(2) == API) parts.drop(2) else parts
        val submission = submissionIn(page)
        return when {
            submission != null && page.any { it in NOT_NOW } -> false
            submission != null -> submissions.find(submission)?.let { sittings.hold(sitting, it) } == true
            page.size < 3 || page[0] != "exercises" -> false
            else -> page[1] in sitting.exam.exercises && page[2] in setOf("pictures", "starter")
        }
    }

    private fun submissionIn(parts: List<String>): String? =
        parts.indexOf("submissions").takeIf { it >= 0 }?.let { parts.getOrNull(it + 1) }

    internal companion object {
        const val EXAMS = "exams"

        /** Parts of an address that ask for what waits until an exam is over. */
        private val NOT_NOW = setOf("complaints", "compare")
        val API = listOf("api", "v1")

        /** The paths that are for everybody, or lead out; nobody comes back as somebody else from an exam. */
        val FREE = setOf("assets", "sign-out", "healthz", "readyz", "metrics", "openapi.json")
    }
}

/** Has [guard] look at each call before it is handled. */
fun Application.guardExams(guard: ExamGuard) =
    intercept(ApplicationCallPipeline.Plugins) { if (!guard.pass(call)) finish() }

/** The student with the session of this browser and the address that it comes from. */
fun ApplicationCall.examinee(student: Identity.StudentIdentity) =
    Examinee(student, sessionCookie().orEmpty(), attributes[Forwarding.CLIENT])
