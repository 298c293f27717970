package rasterlab.grader.web.lti

import io.ktor.http.HttpHeaders
import io.ktor.server.application.ApplicationCall
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.add
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray
import kotlinx.serialization.json.putJsonObject
import rasterlab.grader.forwarding.Forwarding
import rasterlab.grader.lti.Lti
import rasterlab.grader.lti.ScoreSender
import java.net.URI

/**
 * The addresses of this server that a platform is told.
 *
 * @param server without a path
 */
internal class ToolPlaces(
    val server: URI,
) {
    val login = URI("$server/lti/login")
    val launch = URI("$server/lti/launch")
    val keys = URI("$server/lti/jwks")
    val configuration = URI("$server/lti/config.json")
}

/** The addresses that hold for whoever asks: the public one, or else the one that was asked. */
internal fun ApplicationCall.places(lti: Lti): ToolPlaces {
    val public = lti.publicAddress?.toString()?.trimEnd('/')
    val scheme = if (attributes.getOrNull(Forwarding.SECURE) == true) "https" else "http"
    val host = request.headers[HttpHeaders.Host]?.takeIf { HOST.matches(it) } ?: "localhost"
    return ToolPlaces(URI(public ?: "$scheme://$host"))
}

/** Tells a platform what would else be entered there by hand; in the form of Canvas. */
internal fun toolConfiguration(places: ToolPlaces): String =
    Json.encodeToString(
        buildJsonObject {
            put("title", "Rasterlab")
            put("description", "Exercises in computer graphics, graded")
            put("oidc_initiation_url", "${places.login}")
            put("target_link_uri", "${places.launch}")
            putJsonArray("redirect_uris") { add("${places.launch}") }
            put("public_jwk_url", "${places.keys}")
            putJsonArray("scopes") { ScoreSender.SCOPES.forEach { add(it) } }
            putJsonArray("extensions") {
                addJsonObject {
                    put("platform", "canvas.instructure.com")
                    putJsonObject("settings") {
                        putJsonArray("placements") {
                            for (placement in listOf("assignment_selection", "link_selection")) {
                                addJsonObject {
                                    put("placement", placement)
                                    put("message_type", "LtiDeepLinkingRequest")
                                    put("target_link_uri", "${places.launch}")
                                }
                            }
                        }
                    }
                }
            }
        },
    )

private val HOST = Regex("[A-Za-z0-9.-]+(:[0-9]+)?|\\[[0-9A-Fa-f:]+](:[0-9]+)?")
