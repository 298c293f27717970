package rasterlab.grader.web

import io.ktor.http.Cookie
import io.ktor.http.HttpHeaders
import io.ktor.http.HttpMethod
import io.ktor.http.hostWithPort
import io.ktor.http.hostWithPortIfSpecified
import io.ktor.http.parseUrl
import io.ktor.server.application.Application
import io.ktor.server.application.ApplicationCall
import io.ktor.server.application.ApplicationCallPipeline
import io.ktor.server.application.call
import io.ktor.server.request.httpMethod
import io.ktor.server.request.path
import io.ktor.server.response.ApplicationSendPipeline
import io.ktor.server.response.header
import io.ktor.util.AttributeKey
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.course.SESSION_COOKIE
import rasterlab.grader.course.VIEW_COOKIE
import rasterlab.grader.course.sessionCookie
import rasterlab.grader.course.viewedStudent
import rasterlab.grader.forwarding.Forwarding
import rasterlab.grader.problem.LANGUAGES
import rasterlab.grader.problem.Rejection
import java.net.URI

/** Adds what browsers need to know to run nothing but our own files and to tell nobody where they were. */
fun Application.protect() {
    intercept(ApplicationCallPipeline.Plugins) {
        call.response.header("X-Content-Type-Options", "nosniff")
        call.response.header("Referrer-Policy", "same-origin")
        call.response.header("Cross-Origin-Opener-Policy", "same-origin")
        call.rememberLanguage()
    }
    // Who answers may say in which frames; a failure on the way is answered once more.
    sendPipeline.intercept(ApplicationSendPipeline.Before) {
        if (call.attributes.getOrNull(GUARDED) == null) {
            call.attributes.put(GUARDED, Unit)
            call.response.header("Content-Security-Policy", contentPolicy(call.attributes.getOrNull(FRAMES)))
        }
    }
}

private fun contentPolicy(frames: Set<String>?): String {
    val others = frames.orEmpty().joinToString(" ")
    return "default-src 'self'; object-src 'none'; base-uri 'none'; form-action 'self' $others".trim() +
        "; frame-ancestors ${others.ifEmpty { "'none'" }}"
}

/** Lets the pages of these other servers show this answer in a frame, and take a form of it. */
internal fun ApplicationCall.mayBeFramedBy(pages: List<URI>) =
    attributes.put(FRAMES, pages.map { "${it.scheme}://${it.rawAuthority}" }.toSet())

private val FRAMES = AttributeKey<Set<String>>("whose frames may show it")
private val GUARDED = AttributeKey<Unit>("its policy is set")

/** Signs this browser in. Over plain HTTP, as in a classroom, a Secure cookie would never come back. */
fun ApplicationCall.signIn(
    accounts: Accounts,
    who: Identity,
) {
    val secure = attributes.getOrNull(Forwarding.SECURE) == true
    response.cookies.append(cookie(SESSION_COOKIE, accounts.open(who), Accounts.SESSION_LENGTH.seconds.toInt(), secure))
}

fun ApplicationCall.signOut(accounts: Accounts) {
    sessionCookie()?.let(accounts::close)
    viewAs("")
    response.cookies.append(cookie(SESSION_COOKIE, "", 0, secure = false))
}

/** Who signed in with this browser, or null. */
fun ApplicationCall.visitor(accounts: Accounts): Identity? = sessionCookie()?.let(accounts::inSession)

fun ApplicationCall.studentHere(accounts: Accounts): Identity.StudentIdentity =
    someone(accounts) as? Identity.StudentIdentity ?: throw Rejection.WrongRole("student")

fun ApplicationCall.staffHere(accounts: Accounts): Identity.StaffIdentity =
    itself(accounts) as? Identity.StaffIdentity ?: throw Rejection.WrongRole("instructor or assistant")

fun ApplicationCall.instructorHere(accounts: Accounts): Identity.Instructor =
    itself(accounts) as? Identity.Instructor ?: throw Rejection.WrongRole("instructor")

/**
 * Who looks at a page: the student whose view a browser of staff has, and else whoever signed in.
 *
 * @throws Rejection.OnlyLooks where staff would change something in a student's place
 */
fun ApplicationCall.someone(accounts: Accounts): Identity {
    val who = itself(accounts)
    val viewed = viewedStudent(accounts, who) ?: return who
    if (request.httpMethod != HttpMethod.Get) throw Rejection.OnlyLooks()
    attributes.put(VIEWED, viewed)
    return viewed
}

/** The student whose view this page is, which staff have. */
internal val VIEWED = AttributeKey<Identity.StudentIdentity>("the student whose view staff have")

private fun ApplicationCall.itself(accounts: Accounts): Identity = visitor(accounts) ?: throw Rejection.NotSignedIn()

/** Gives this browser of staff the view of a student; an empty id gives back its own. */
internal fun ApplicationCall.viewAs(student: String) {
    val seconds = if (student.isEmpty()) 0 else Accounts.SESSION_LENGTH.seconds.toInt()
    response.cookies.append(cookie(VIEW_COOKIE, student, seconds, attributes.getOrNull(Forwarding.SECURE) == true))
}

/** Lets a form through only if the browser says that one of our own pages sent it. */
fun ApplicationCall.requireOwnForm() {
    val host = request.headers[HttpHeaders.Host]
    val sender = request.headers[HttpHeaders.Origin]
    if (host == null || sender?.substringAfter("://") != host) throw Rejection.ForeignOrigin()
}

/** The page of this server that this request was sent from, unless it was this one; null if no browser says. */
fun ApplicationCall.pageBefore(): String? {
    val page = request.headers[HttpHeaders.Referrer]?.let(::parseUrl) ?: return null
    if (request.headers[HttpHeaders.Host] !in setOf(page.hostWithPort, page.hostWithPortIfSpecified)) return null
    return page.encodedPath.here().takeIf { it != request.path() || request.httpMethod != HttpMethod.Get }
}

/** This path as one of ours, since `//host` would lead away. */
fun String.here() = "/" + trimStart('/')

private fun ApplicationCall.rememberLanguage() {
    val asked = request.rawQueryParameters["lang"] ?: return
    if (asked in LANGUAGES) response.cookies.append(cookie(LANGUAGE_COOKIE, asked, YEAR_SECONDS, secure = false))
}

private fun cookie(
    name: String,
    value: String,
    seconds: Int,
    secure: Boolean,
) = Cookie(
    name,
    value,
    maxAge = seconds,
    path = "/",
    secure = secure,
    httpOnly = true,
    extensions = mapOf("SameSite" to "Strict"),
)

private const val YEAR_SECONDS = 365 * 24 * 3600
