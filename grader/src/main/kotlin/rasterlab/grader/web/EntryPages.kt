package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.http.Parameters
import io.ktor.http.parseUrlEncodedParameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import kotlinx.html.FlowContent
import kotlinx.html.FlowOrPhrasingContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.code
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.p
import kotlinx.html.role
import kotlinx.html.section
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.course.StaffRole
import rasterlab.grader.institution.InstitutionSignIn
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.receiveAtMost
import rasterlab.grader.problem.utf8

private const val FORM_BYTES = 16 * 1024

fun Route.welcome(
    accounts: Accounts,
    institution: InstitutionSignIn?,
) {
    get("/") {
        when (call.visitor(accounts)) {
            is Identity.StudentIdentity -> call.respondRedirect("/exercises")
            is Identity.StaffIdentity -> call.respondRedirect("/instructor")
            null -> call.respondWelcome(institution, problem = null)
        }
    }
    post("/sign-out") {
        call.requireOwnForm()
        call.signOut(accounts)
        call.respondRedirect("/")
    }
}

/** Joining and signing in, inside a rate limit. */
fun Route.entering(
    accounts: Accounts,
    courses: Courses,
    institution: InstitutionSignIn?,
) {
    post("/join") {
        call.requireOwnForm()
        val form = call.receiveForm()
        val student = courses.join(form["course"].orEmpty(), Name.of(form["name"].orEmpty()), key = null)
        accounts.holder(student.token)?.let { call.signIn(accounts, it) }
        call.respondJoined(student.token)
    }
    post("/sign-in") {
        call.requireOwnForm()
        val who = accounts.holder(call.receiveForm()["token"].orEmpty().trim())
        if (who == null) {
            call.respondWelcome(institution, problem = "bad-token")
        } else {
            call.signIn(accounts, who)
            call.respondRedirect("/")
        }
    }
}

/** The fields of a small form. */
suspend fun ApplicationCall.receiveForm(): Parameters = receiveForm(FORM_BYTES)

/** The fields of a form of at most [limit] bytes. */
suspend fun ApplicationCall.receiveForm(limit: Int): Parameters =
    utf8(receiveAtMost(limit)) { Rejection.Malformed("the form is not UTF-8 text: $it") }
        .replace("+", "%20")
        .parseUrlEncodedParameters()

private suspend fun ApplicationCall.respondWelcome(
    institution: InstitutionSignIn?,
    problem: String?,
) {
    val texts = texts()
    val status = if (problem == null) HttpStatusCode.OK else HttpStatusCode.Unauthorized
    respondPage(texts, who = null, texts.say("entry.title"), status) {
        problem?.let {
            p("problem") {
                role = "alert"
                +texts.problem(it)
            }
        }
        div("columns") {
            institution?.let { byInstitution(texts, it) }
            entry(texts, "join", "/join") {
                field(texts.say("entry.code"), "course")
                field(texts.say("entry.name"), "name", filling = "name")
            }
            entry(texts, "in", "/sign-in") {
                field(texts.say("entry.token"), "token", InputType.password, filling = "current-password")
            }
        }
    }
}

/** The link that fills the token in for who opens it: a browser sends nothing of what stands behind #. */
internal fun FlowOrPhrasingContent.signInLink(
    texts: PageTexts,
    token: String,
) {
    +" "
    a("/#token=$token") { +texts.say("token.link") }
}

private fun FlowContent.byInstitution(
    texts: PageTexts,
    institution: InstitutionSignIn,
) = section("card") {
    h2 { +texts.say("entry.institution") }
    p { +texts.say("entry.institution.about") }
    p("ways") {
        a("/sign-in/institution", classes = "button") { +texts.say("entry.institution.do") }
        institution.exit()?.let {
            +" "
            a(it.toString()) { +texts.say("entry.institution.out") }
        }
    }
}

private fun FlowContent.entry(
    texts: PageTexts,
    kind: String,
    action: String,
    fields: FlowContent.() -> Unit,
) = section("card") {
    h2 { +texts.say("entry.$kind") }
    p { +texts.say("entry.$kind.about") }
    form(action, method = FormMethod.post) {
        fields()
        button { +texts.say("entry.$kind.do") }
    }
}

private suspend fun ApplicationCall.respondJoined(token: String) {
    val texts = texts()
    respondPage(texts, who = null, texts.say("joined.title")) {
        section("card") {
            p { +texts.say("joined.keep") }
            p { code("token") { +token } }
            p { a("/exercises", classes = "button") { +texts.say("joined.go") } }
        }
    }
}

/**
 * Signs the browser in and lets it go on by itself: behind a redirection that another site began, it would not send
 * the cookie of the session.
 *
 * @param course its name; empty for staff, who teach all
 * @param page of ours to go on to
 */
internal suspend fun ApplicationCall.arrive(
    accounts: Accounts,
    who: Identity,
    course: String,
    page: String,
) {
    signIn(accounts, who)
    val texts = texts()
    response.header("Refresh", "0; url=$page")
    respondPage(texts, who = null, texts.say("institution.in")) {
        section("card") {
            p { +texts.say("institution.in.as", texts.nameOf(who, course)) }
            p { a(page, classes = "button") { +texts.say("institution.on") } }
        }
    }
}

/** The name with the role of staff, or with the course of a student. */
internal fun PageTexts.nameOf(
    who: Identity,
    course: String,
): String {
    val place =
        when (who) {
            is Identity.StaffIdentity -> say("nav.${StaffRole.of(who).code}")
            is Identity.StudentIdentity -> course
        }
    return listOf(who.name, place).filter { it.isNotEmpty() }.joinToString(" · ")
}
