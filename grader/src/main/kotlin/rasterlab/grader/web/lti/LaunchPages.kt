// The pages on which people arrive from learning platforms, and those about these.
package rasterlab.grader.web.lti

import io.ktor.http.ContentType
import io.ktor.http.Cookie
import io.ktor.http.CookieEncoding
import io.ktor.http.HttpStatusCode
import io.ktor.http.Parameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.response.respondText
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.util.toMap
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.fieldSet
import kotlinx.html.form
import kotlinx.html.hiddenInput
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.legend
import kotlinx.html.p
import kotlinx.html.role
import kotlinx.html.section
import kotlinx.html.span
import org.slf4j.LoggerFactory
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.lti.Launch
import rasterlab.grader.lti.LaunchStep
import rasterlab.grader.lti.LoginWish
import rasterlab.grader.lti.Lti
import rasterlab.grader.lti.LtiFault
import rasterlab.grader.lti.LtiRefused
import rasterlab.grader.problem.Rejection
import rasterlab.grader.rules.CourseExercises
import rasterlab.grader.storage.OnceOnly
import rasterlab.grader.storage.Secrets
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.arrive
import rasterlab.grader.web.field
import rasterlab.grader.web.mayBeFramedBy
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.texts
import java.net.URI

/** Tells platforms what this server is to them; for programs. */
fun Route.toolPages(lti: Lti) {
    get("/lti/jwks") { call.respondText(lti.key.publicSet(), ContentType.Application.Json) }
    get("/lti/config.json") { call.respondText(toolConfiguration(call.places(lti)), ContentType.Application.Json) }
}

/** Lets people in whom a platform sends, by the messages of LTI 1.3; inside a rate limit. */
fun Route.launchPages(
    lti: Lti,
    accounts: Accounts,
    exercises: Exercises,
    chosen: CourseExercises,
) {
    val desk = LaunchDesk(lti, accounts, exercises, chosen)
    get("/lti/login") { desk.handle(call) { begin(call, call.request.queryParameters) } }
    post("/lti/login") { desk.handle(call) { begin(call, call.receiveForm(LAUNCH_BYTES)) } }
    post("/lti/launch") { desk.handle(call) { end(call, call.receiveForm(LAUNCH_BYTES)) } }
    post("/lti/staff") { desk.goOn(call) { launch, form -> lti.arrivals.tell(launch, form["token"].orEmpty()) } }
    post("/lti/course") {
        desk.goOn(call) { launch, form ->
            lti.arrivals.bind(launch, form["course"].orEmpty(), form["name"].orEmpty())
        }
    }
    post("/lti/open") { desk.goOn(call, above = true) { _, _ -> } }
    post("/lti/links") { desk.handle(call) { answerLinks(call) } }
}

/** Room for a signed message with all that a platform tells. */
private const val LAUNCH_BYTES = 128 * 1024

private class LaunchDesk(
    private val lti: Lti,
    private val accounts: Accounts,
    private val exercises: Exercises,
    private val had: CourseExercises,
) {
    suspend fun handle(
        call: ApplicationCall,
        work: suspend LaunchDesk.() -> Unit,
    ) {
        call.mayBeFramedBy(lti.platforms.all().map { it.login })
        try {
            work()
        } catch (refused: LtiRefused) {
            call.respondRefused(refused)
        }
    }

    suspend fun begin(
        call: ApplicationCall,
        told: Parameters,
    ) {
        val issuer = told["iss"] ?: throw LtiRefused(LtiFault.MESSAGE, "no 'iss'")
        val hint = told["login_hint"] ?: throw LtiRefused(LtiFault.MESSAGE, "no 'login_hint'")
        val wish =
            LoginWish(issuer, hint, told["client_id"], told["lti_deployment_id"], told["lti_message_hint"])
        val errand = lti.launches.begin(wish, call.places(lti).launch)
        call.response.cookies.append(cookie(errand.state, errand.browser, OnceOnly.LIFE.seconds.toInt()))
        call.respondRedirect("${errand.place}")
    }

    suspend fun end(
        call: ApplicationCall,
        told: Parameters,
    ) {
        val name = told["state"]?.let(::cookieName)
        val browser = name?.let { call.request.cookies[it, CookieEncoding.RAW] }
        if (name != null && browser != null) call.response.cookies.append(cookie(told["state"].orEmpty(), "", 0))
        proceed(call, lti.launches.finish(browser, told.toMap()), above = false)
    }

    /** Goes on with a launch after a question of ours is answered. */
    suspend fun goOn(
        call: ApplicationCall,
        above: Boolean = false,
        answered: (Launch, Parameters) -> Unit,
    ) = handle(call) {
        call.requireOwnForm()
        val form = call.receiveForm()
        val launch = lti.arrivals.take(form[KEY])
        try {
            answered(launch, form)
            proceed(call, launch, above)
        } catch (refused: LtiRefused) {
            if (refused.why != LtiFault.TOKEN) throw refused
            call.respondWho(launch, refused.why.code)
        } catch (refused: Rejection.BadName) {
            val arrival = lti.arrivals.next(launch)
            if (arrival !is LaunchStep.WhichCourse) throw refused
            call.respondWhichCourse(arrival, refused.code)
        }
    }

    /** @param above whether the page is certainly in no frame */
    private suspend fun proceed(
        call: ApplicationCall,
        launch: Launch,
        above: Boolean,
    ) {
        call.allowFrame(launch)
        when (val arrival = lti.arrivals.next(launch)) {
            is LaunchStep.WhoAreYou -> call.respondWho(launch, problem = null)
            is LaunchStep.WhichCourse -> call.respondWhichCourse(arrival, problem = null)
            is LaunchStep.WhichExercises -> call.respondChoice(arrival, problem = null)
            is LaunchStep.LetIn -> enter(call, arrival, above)
        }
    }

    /** The cookie of the session is not for frames of other sites, so from there a window of its own is opened. */
    private suspend fun enter(
        call: ApplicationCall,
        entry: LaunchStep.LetIn,
        above: Boolean,
    ) {
        if (above || call.request.headers["Sec-Fetch-Dest"] == "document") {
            call.arrive(accounts, entry.who, entry.course, entry.page)
        } else {
            call.respondWindow(entry)
        }
    }

    suspend fun answerLinks(call: ApplicationCall) {
        call.requireOwnForm()
        val form = call.receiveForm()
        val launch = lti.arrivals.take(form[KEY])
        call.allowFrame(launch)
        val arrival = lti.arrivals.next(launch)
        if (arrival !is LaunchStep.WhichExercises) throw LtiRefused(LtiFault.STALE, "this launch asked for no links")
        val chosen =
            form
                .getAll("exercise")
                .orEmpty()
                .distinct()
                .map { id -> of(arrival.course).firstOrNull { it.id() == id } ?: throw Rejection.UnknownExercise(id) }
        if (chosen.isEmpty() || (chosen.size > 1 && !arrival.wish.several)) {
            return call.respondChoice(arrival, "lti-choice")
        }
        val target = call.places(lti).launch
        val answer = lti.deepLinks.answer(launch, arrival.wish, chosen, target, call.texts().language)
        call.respondAnswer(arrival, answer, chosen.size)
    }

    /** The exercises that a course has. */
    private fun of(course: Course) = had.of(course.id).map(exercises::named)

    private fun ApplicationCall.allowFrame(launch: Launch) {
        launch.from?.let { from -> mayBeFramedBy(lti.platforms.all().map { it.login } + URI(from)) }
    }

    private suspend fun ApplicationCall.respondWho(
        launch: Launch,
        problem: String?,
    ) = respondQuestion(launch, "lti.who", "/lti/staff", problem) { texts ->
        field(texts.say("entry.token"), "token", InputType.password, filling = "current-password")
        button { +texts.say("lti.who.do") }
    }

    private suspend fun ApplicationCall.respondWhichCourse(
        arrival: LaunchStep.WhichCourse,
        problem: String?,
    ) = respondQuestion(arrival.launch, "lti.course", "/lti/course", problem) { texts ->
        fieldSet {
            legend { +texts.say("lti.course.which", arrival.launch.title) }
            arrival.courses.forEach { one -> choice(InputType.radio, "course", one.id, one.name, chosen = false) }
            choice(InputType.radio, "course", "", texts.say("lti.course.new"), chosen = true)
        }
        label {
            span { +texts.say("lti.course.name") }
            input(InputType.text, name = "name") {
                value = arrival.launch.title
                attributes["autocomplete"] = "off"
            }
        }
        button { +texts.say("lti.course.do") }
    }

    private suspend fun ApplicationCall.respondChoice(
        arrival: LaunchStep.WhichExercises,
        problem: String?,
    ) = respondQuestion(arrival.launch, "lti.links", "/lti/links", problem) { texts ->
        val kind = if (arrival.wish.several) InputType.checkBox else InputType.radio
        fieldSet {
            legend { +texts.say("lti.links.which", arrival.course.name) }
            of(arrival.course).forEach { one ->
                val points = texts.say("exercises.points", one.points().total())
                choice(kind, "exercise", one.id(), "${one.title(texts.language)} · $points", chosen = false)
            }
        }
        button { +texts.say("lti.links.do") }
    }

    /** Asks something that the launch needs to go on, and keeps it until that is answered. */
    private suspend fun ApplicationCall.respondQuestion(
        launch: Launch,
        texts: String,
        action: String,
        problem: String?,
        fields: FlowContent.(PageTexts) -> Unit,
    ) {
        val key = lti.arrivals.keep(launch)
        val words = texts()
        val status = if (problem == null) HttpStatusCode.OK else HttpStatusCode.UnprocessableEntity
        respondPage(words, who = null, words.say("$texts.title"), status) {
            problem?.let {
                p("problem") {
                    role = "alert"
                    +words.problem(it)
                }
            }
            section("card") {
                p { +words.say("$texts.about") }
                form(action, method = FormMethod.post) {
                    hiddenInput(name = KEY) { value = key }
                    fields(words)
                }
            }
        }
    }

    private suspend fun ApplicationCall.respondWindow(entry: LaunchStep.LetIn) {
        val key = lti.arrivals.keep(entry.launch)
        val texts = texts()
        respondPage(texts, who = null, texts.say("lti.window.title")) {
            section("card") {
                p { +texts.say("lti.window.about") }
                form("/lti/open", method = FormMethod.post) {
                    target = "_blank"
                    hiddenInput(name = KEY) { value = key }
                    button { +texts.say("lti.window.do") }
                }
            }
        }
    }

    private suspend fun ApplicationCall.respondAnswer(
        arrival: LaunchStep.WhichExercises,
        answer: String,
        count: Int,
    ) {
        val texts = texts()
        respondPage(texts, who = null, texts.say("lti.answer.title")) {
            section("card") {
                p { +texts.say("lti.answer.about", count) }
                form(arrival.wish.answer, method = FormMethod.post) {
                    attributes["data-send"] = ""
                    hiddenInput(name = "JWT") { value = answer }
                    button { +texts.say("lti.answer.do") }
                }
            }
        }
    }

    private suspend fun ApplicationCall.respondRefused(refused: LtiRefused) {
        LOG.info("launch refused: {}{}", refused.message, refused.cause?.let { " (${it.message})" }.orEmpty())
        val texts = texts()
        respondPage(texts, who = null, texts.say("institution.refused"), refused.why.status()) {
            section("card") {
                p("problem") {
                    role = "alert"
                    +texts.problem(refused.why.code)
                }
                p("ways") { a("/") { +texts.say("error.back") } }
            }
        }
    }
}

private fun FlowContent.choice(
    kind: InputType,
    field: String,
    choice: String,
    words: String,
    chosen: Boolean,
) = label("consent") {
    input(kind, name = field) {
        value = choice
        checked = chosen
    }
    span { +words }
}

private fun LtiFault.status() =
    when (this) {
        LtiFault.STALE, LtiFault.NO_COOKIE, LtiFault.MESSAGE, LtiFault.UNKNOWN_PLATFORM -> HttpStatusCode.BadRequest
        LtiFault.AWAY -> HttpStatusCode.ServiceUnavailable
        LtiFault.TOKEN -> HttpStatusCode.Unauthorized
        else -> HttpStatusCode.Forbidden
    }

private const val KEY = "launch"
private val LOG = LoggerFactory.getLogger("rasterlab.grader.lti")

/** Several launches may go on in one browser, each in a frame of its own. */
private fun cookieName(state: String) = "rasterlab-lti-" + Secrets.hash(state).take(COOKIE_NAME)

private const val COOKIE_NAME = 16

/**
 * A cookie that comes along when the platform sends the browser back by a form, also in a frame: browsers then keep it for
 * frames of that platform alone. They take it over an encrypted connection only, or on one machine.
 */
private fun cookie(
    state: String,
    value: String,
    seconds: Int,
) = Cookie(
    cookieName(state),
    value,
    CookieEncoding.RAW,
    maxAge = seconds,
    path = "/lti",
    secure = true,
    httpOnly = true,
    extensions = mapOf("SameSite" to "None", "Partitioned" to null),
)
