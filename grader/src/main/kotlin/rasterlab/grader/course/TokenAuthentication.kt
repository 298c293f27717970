package rasterlab.grader.course

import io.ktor.http.CookieEncoding
import io.ktor.http.HttpHeaders
import io.ktor.http.HttpMethod
import io.ktor.http.decodeURLPart
import io.ktor.server.application.ApplicationCall
import io.ktor.server.auth.AuthenticationConfig
import io.ktor.server.auth.AuthenticationContext
import io.ktor.server.auth.AuthenticationProvider
import io.ktor.server.request.httpMethod
import io.ktor.server.request.path
import rasterlab.grader.problem.Rejection

const val SESSION_COOKIE = "rasterlab"

/** The session cookie of the browser, as it was sent: our sessions need no decoding, and it may be anything. */
fun ApplicationCall.sessionCookie(): String? = request.cookies[SESSION_COOKIE, CookieEncoding.RAW]

/** Who calls by token and who by cookie: pages look at the one, the API at the other. */
internal fun Accounts.callers(call: ApplicationCall): List<Identity> {
    val token =
        call.request.headers[HttpHeaders.Authorization]
            ?.substringAfter(' ', "")
            ?.trim()
    return listOfNotNull(token?.let(::holder), call.sessionCookie()?.let(::inSession))
}

/** The parts of the address between its slashes, decoded. */
internal fun ApplicationCall.addressParts(): List<String> =
    request
        .path()
        .split('/')
        .filter { it.isNotEmpty() }
        .map { it.decodeURLPart() }

/**
 * Lets in the holder of a bearer token.
 *
 * A page's pictures and events cannot send that header, so a session cookie does for reading; never
 * for changing anything, because a browser sends cookies with requests that other sites start.
 */
fun AuthenticationConfig.byToken(accounts: Accounts) = register(TokenAuthentication(accounts, Config()))

private class Config : AuthenticationProvider.Config(null)

private class TokenAuthentication(
    private val accounts: Accounts,
    config: Config,
) : AuthenticationProvider(config) {
    override suspend fun onAuthenticate(context: AuthenticationContext) {
        val who = bearer(context.call) ?: session(context.call) ?: throw Rejection.NotSignedIn()
        context.principal(who)
    }

    private fun bearer(call: ApplicationCall): Identity? =
        call.request.headers[HttpHeaders.Authorization]
            ?.takeIf { it.startsWith("Bearer ", ignoreCase = true) }
            ?.let { accounts.holder(it.substring("Bearer ".length).trim()) }

    private fun session(call: ApplicationCall): Identity? =
        call
            .sessionCookie()
            ?.takeIf { call.request.httpMethod == HttpMethod.Get }
            ?.let(accounts::inSession)
}
