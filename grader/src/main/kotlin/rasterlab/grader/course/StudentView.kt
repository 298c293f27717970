package rasterlab.grader.course

import io.ktor.http.CookieEncoding
import io.ktor.server.application.ApplicationCall

/** The cookie in which a browser of staff keeps whose view it has: the id of a student. */
const val VIEW_COOKIE = "rasterlab-view"

/** Whether this browser asks for the view of a student; only one of staff gets it. */
fun ApplicationCall.hasView(): Boolean = request.cookies[VIEW_COOKIE, CookieEncoding.RAW] != null

/** The student whose view this browser of [who] has; null where it has its own. */
fun ApplicationCall.viewedStudent(
    accounts: Accounts,
    who: Identity,
): Identity.StudentIdentity? {
    if (who !is Identity.StaffIdentity) return null
    val student = request.cookies[VIEW_COOKIE, CookieEncoding.RAW] ?: return null
    return (accounts.withId(student) as? Identity.StudentIdentity)?.takeIf { who.teaches(it.course) }
}
