package rasterlab.grader.lti

import com.nimbusds.jose.jwk.JWKSet
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.http.Parameters
import io.ktor.http.formUrlEncode
import org.junit.jupiter.api.Assertions.assertEquals
import rasterlab.grader.Visit
import java.net.URI
import java.time.InstantSource

/** A launch that has begun in a browser. */
class BegunVisit(
    val place: URI,
    val cookie: String,
)

/** Registers the platform, and lets it read the tool's keys. */
suspend fun Visit.register(
    platform: LocalPlatform,
    makesStaff: Boolean = false,
): Platform {
    val keys = JWKSet.parse(client.get("/lti/jwks").bodyAsText())
    platform.toolKeys = { keys }
    return Platforms(database, InstantSource.system()).add(platform.form(makesStaff), "test", key = null)
}

/** Begins a launch, as a browser does that the platform sends. */
suspend fun Visit.beginLaunch(platform: LocalPlatform): HttpResponse =
    client.post("/lti/login") {
        header(HttpHeaders.Host, "localhost")
        header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
        setBody(
            Parameters
                .build {
                    append("iss", platform.issuer)
                    append("login_hint", "hint")
                    append("lti_message_hint", "message")
                    append("client_id", LocalPlatform.CLIENT)
                    append("target_link_uri", "http://localhost/lti/launch")
                }.formUrlEncode(),
        )
    }

suspend fun HttpResponse.begun(): BegunVisit {
    assertEquals(302, status.value, bodyAsText())
    val cookie = checkNotNull(headers[HttpHeaders.SetCookie])
    for (part in listOf("SameSite=None", "Secure", "HttpOnly", "Partitioned", "Path=/lti")) {
        check(part in cookie) { "$part is missing in $cookie" }
    }
    return BegunVisit(URI(checkNotNull(headers[HttpHeaders.Location])), cookie.substringBefore(';'))
}

/** Posts the platform's form, in a window of its own or in a frame. */
suspend fun Visit.endLaunch(
    form: Parameters,
    cookie: String?,
    frame: Boolean = false,
): HttpResponse =
    client.post("/lti/launch") {
        header(HttpHeaders.Host, "localhost")
        header(HttpHeaders.Origin, "http://127.0.0.1")
        header("Sec-Fetch-Dest", if (frame) "iframe" else "document")
        header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
        cookie?.let { header(HttpHeaders.Cookie, it) }
        setBody(form.formUrlEncode())
    }

/** A whole launch. */
suspend fun Visit.launch(
    platform: LocalPlatform,
    frame: Boolean = false,
): HttpResponse {
    val begun = beginLaunch(platform).begun()
    return endLaunch(platform.answer(begun.place), begun.cookie, frame)
}

/** Answers a page's question: its form with these fields added. */
suspend fun Visit.reply(
    page: HttpResponse,
    action: String,
    vararg fields: Pair<String, String>,
): HttpResponse {
    val text = page.bodyAsText()
    check("action=\"$action\"" in text) { "no form for $action: $text" }
    val key = checkNotNull(Regex("name=\"launch\" value=\"([^\"]+)\"").find(text)) { text }.groupValues[1]
    return client.post(action) {
        header(HttpHeaders.Host, "localhost")
        header(HttpHeaders.Origin, "http://localhost")
        header("Sec-Fetch-Dest", "document")
        header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
        setBody((listOf("launch" to key) + fields).formUrlEncode())
    }
}

/** Lets an instructor who comes from the platform join its course with a new one here. */
suspend fun Visit.bindCourse(platform: LocalPlatform) {
    val roles = platform.roles
    val person = platform.person
    platform.roles = listOf("${LocalPlatform.MEMBERSHIP}#Instructor")
    platform.person = "grace-there"
    val who = launch(platform)
    val which = reply(who, "/lti/staff", "token" to instructor)
    val arrived = reply(which, "/lti/course", "course" to "", "name" to "Graphics")
    assertEquals(200, arrived.status.value, arrived.bodyAsText())
    assertEquals("0; url=/exercises/draw-dot", arrived.headers["Refresh"])
    platform.roles = roles
    platform.person = person
}

/** The cookie of the session that this answer opens; null where it opens none. */
fun HttpResponse.session(): String? =
    headers
        .getAll(HttpHeaders.SetCookie)
        .orEmpty()
        .singleOrNull { it.startsWith("rasterlab=") }
        ?.substringBefore(';')
