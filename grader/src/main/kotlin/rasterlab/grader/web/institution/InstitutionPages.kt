// The pages of signing in by the institution.
package rasterlab.grader.web.institution

import io.ktor.http.Cookie
import io.ktor.http.CookieEncoding
import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respond
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.util.toMap
import kotlinx.html.FormMethod
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.form
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.role
import kotlinx.html.section
import kotlinx.html.ul
import org.slf4j.LoggerFactory
import rasterlab.grader.course.Accounts
import rasterlab.grader.forwarding.Forwarding
import rasterlab.grader.institution.Entrances
import rasterlab.grader.institution.Errand
import rasterlab.grader.institution.InstitutionSignIn
import rasterlab.grader.institution.SignInFault
import rasterlab.grader.institution.SignInRefused
import rasterlab.grader.web.arrive
import rasterlab.grader.web.nameOf
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.texts

/** Where people go to sign in by their institution. */
const val INSTITUTION = "/sign-in/institution"

/** Where the provider sends people back to, below the server's public address. */
const val INSTITUTION_BACK = "$INSTITUTION/back"

/**
 * Begins and ends sign-ins by the institution.
 *
 * @param signIn null where the server has none
 */
fun Route.institutionPages(
    signIn: InstitutionSignIn?,
    accounts: Accounts,
) {
    fun page(work: suspend ApplicationCall.(InstitutionSignIn) -> Unit): suspend (ApplicationCall) -> Unit =
        { call ->
            if (signIn == null) {
                call.respond(HttpStatusCode.NotFound)
            } else {
                try {
                    call.work(signIn)
                } catch (refused: SignInRefused) {
                    call.respondRefused(refused)
                }
            }
        }

    val entry =
        page {
            val page = ownPage(request.rawQueryParameters["to"])
            if (it.header == null) leave(it.begin(page)) else enter(it, accounts, it.named(toldByProxy(it), page))
        }
    val back = page { enter(it, accounts, it.finish(keyHere(), request.queryParameters.toMap())) }
    val choice =
        page { sign ->
            requireOwnForm()
            val account = receiveForm()["account"]
            val choices = sign.choices(keyHere())
            val chosen = choices.all.find { it.who.id == account } ?: throw SignInRefused(SignInFault.STALE)
            arrive(accounts, chosen.who, chosen.course, choices.page)
        }
    get(INSTITUTION) { entry(call) }
    get(INSTITUTION_BACK) { back(call) }
    post("$INSTITUTION/account") { choice(call) }
}

/** The path of a page of ours; the start page for anything else, which could lead away or in a circle. */
internal fun ownPage(asked: String?): String =
    asked?.takeIf { OWN_PAGE.matches(it) && !it.startsWith(INSTITUTION) } ?: "/"

private val OWN_PAGE = Regex("(/[A-Za-z0-9._~-]+)+")

/** The name that a trusted proxy tells; null where the connection is not its own, or it tells none or several. */
private fun ApplicationCall.toldByProxy(signIn: InstitutionSignIn): String? {
    if (attributes.getOrNull(Forwarding.FROM_PROXY) != true) return null
    val told =
        signIn.header
            ?.let { request.headers.getAll(it) }
            .orEmpty()
            .singleOrNull()
    return told?.trim()?.takeIf { it.isNotEmpty() && ',' !in it }
}

private suspend fun ApplicationCall.leave(errand: Errand) {
    keep(errand.key)
    respondRedirect(errand.place.toString())
}

private suspend fun ApplicationCall.enter(
    signIn: InstitutionSignIn,
    accounts: Accounts,
    found: Entrances,
) {
    val only = found.all.singleOrNull() ?: return respondChoice(signIn, found)
    arrive(accounts, only.who, only.course, found.page)
}

private suspend fun ApplicationCall.respondChoice(
    signIn: InstitutionSignIn,
    found: Entrances,
) {
    keep(signIn.keep(found))
    val texts = texts()
    respondPage(texts, who = null, texts.say("institution.choose")) {
        section("card") {
            p { +texts.say("institution.choose.about") }
            form("$INSTITUTION/account", method = FormMethod.post) {
                ul {
                    found.all.forEach { one ->
                        li {
                            button {
                                name = "account"
                                value = one.who.id
                                +texts.nameOf(one.who, one.course)
                            }
                        }
                    }
                }
            }
        }
    }
}

private suspend fun ApplicationCall.respondRefused(refused: SignInRefused) {
    LOG.info("sign-in by the institution: {}{}", refused.message, refused.cause?.let { " (${it.message})" }.orEmpty())
    val texts = texts()
    respondPage(texts, who = null, texts.say("institution.refused"), refused.why.status()) {
        section("card") {
            p("problem") {
                role = "alert"
                +texts.problem(refused.why.code)
            }
            refused.named?.let { p { +texts.say("institution.named", it) } }
            p("ways") {
                a(INSTITUTION) { +texts.say("institution.again") }
                +" "
                a("/") { +texts.say("error.back") }
            }
        }
    }
}

private fun SignInFault.status() =
    when (this) {
        SignInFault.STALE -> HttpStatusCode.BadRequest
        SignInFault.AWAY -> HttpStatusCode.ServiceUnavailable
        else -> HttpStatusCode.Forbidden
    }

/** The key that this browser was given, which opens one thing once. */
private fun ApplicationCall.keyHere(): String? = request.cookies[KEY_COOKIE, CookieEncoding.RAW]

private fun ApplicationCall.keep(key: String) =
    response.cookies.append(cookie(key, InstitutionSignIn.PATIENCE.seconds.toInt()))

/** A cookie that comes along when the provider sends the browser back, as one of the session itself would not. */
private fun ApplicationCall.cookie(
    key: String,
    seconds: Int,
) = Cookie(
    KEY_COOKIE,
    key,
    maxAge = seconds,
    path = INSTITUTION,
    secure = attributes.getOrNull(Forwarding.SECURE) == true,
    httpOnly = true,
    extensions = mapOf("SameSite" to "Lax"),
)

private const val KEY_COOKIE = "rasterlab-institution"
private val LOG = LoggerFactory.getLogger("rasterlab.grader.institution")
