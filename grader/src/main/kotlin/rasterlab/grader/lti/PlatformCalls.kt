package rasterlab.grader.lti

import com.nimbusds.jose.JOSEException
import com.nimbusds.jose.JWSAlgorithm
import com.nimbusds.oauth2.sdk.ClientCredentialsGrant
import com.nimbusds.oauth2.sdk.ParseException
import com.nimbusds.oauth2.sdk.Scope
import com.nimbusds.oauth2.sdk.TokenRequest
import com.nimbusds.oauth2.sdk.TokenResponse
import com.nimbusds.oauth2.sdk.auth.PrivateKeyJWT
import com.nimbusds.oauth2.sdk.http.HTTPRequest
import com.nimbusds.oauth2.sdk.http.HTTPResponse
import com.nimbusds.oauth2.sdk.id.ClientID
import io.ktor.http.URLBuilder
import io.ktor.http.appendPathSegments
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.contentOrNull
import kotlinx.serialization.json.put
import rasterlab.grader.institution.Outside
import rasterlab.grader.institution.ProviderSettings
import java.io.IOException
import java.net.URI
import java.net.URISyntaxException
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import java.util.concurrent.ConcurrentHashMap

/**
 * A platform that does not do what it was asked.
 *
 * @param code a word, or the status of its answer
 * @param asWhole whether it would not do others' either just now
 */
internal class PlatformFault(
    val code: String,
    val asWhole: Boolean,
    cause: Exception? = null,
) : Exception(code, cause)

/** Asks platforms to make line items and to take scores, with leave that they give to whoever has this server's key. */
internal class PlatformCalls(
    private val key: ToolKey,
    private val clock: InstantSource,
) {
    private class Leave(
        val header: String,
        val until: Instant,
    )

    private val leaves = ConcurrentHashMap<String, Leave>()

    /**
     * Finds the line item of a link, or makes it.
     *
     * @param link what the platform calls it
     * @param title of a new one
     * @return its address
     */
    fun lineItem(
        platform: Platform,
        lineItems: String,
        link: String,
        score: DueScore,
        title: String,
    ): String {
        val search = URLBuilder(lineItems).apply { parameters.append("resource_link_id", link) }.buildString()
        val found = ask(platform, get(search), LINE_ITEM)
        val items = json(found) as? JsonArray ?: throw PlatformFault(UNREADABLE, asWhole = false)
        items
            .filterIsInstance<JsonObject>()
            .firstOrNull { it.text("resourceLinkId") == link && it.text("resourceId") in setOf(null, score.exercise) }
            ?.let { return address(it) }
        val wanted =
            buildJsonObject {
                put("scoreMaximum", score.of)
                put("label", title)
                put("resourceId", score.exercise)
                put("resourceLinkId", link)
            }
        return address(json(ask(platform, post(lineItems, ITEM_TYPE, "$wanted"), LINE_ITEM)) as? JsonObject)
    }

    /**
     * Sends a score. A platform that says that it has one of that moment or later has taken it before: its answer was lost.
     *
     * @throws PlatformFault
     */
    fun score(
        platform: Platform,
        lineItem: String,
        score: DueScore,
    ) {
        val place = URLBuilder(lineItem).apply { appendPathSegments("scores") }.buildString()
        val body =
            buildJsonObject {
                put("userId", score.subject)
                put("timestamp", score.changedAt)
                if (score.points == null) {
                    put("activityProgress", "Initialized")
                    put("gradingProgress", "NotReady")
                } else {
                    put("scoreGiven", score.points)
                    put("scoreMaximum", score.of)
                    put("activityProgress", "Submitted")
                    put("gradingProgress", "FullyGraded")
                }
            }
        ask(platform, post(place, SCORE_TYPE, "$body"), SCORE, taken = CONFLICT)
    }

    /** Asks with leave; where the leave has ended early, once more with a new one. */
    private fun ask(
        platform: Platform,
        request: () -> HTTPRequest,
        scope: String,
        taken: Int = OK,
    ): HTTPResponse =
        asking {
            val first = send(request(), leave(platform, scope))
            val answer =
                if (first.statusCode != UNAUTHORIZED) {
                    first
                } else {
                    leaves.remove("${platform.id} $scope")
                    send(request(), leave(platform, scope))
                }
            if (!answer.indicatesSuccess() && answer.statusCode != taken) {
                val whole = answer.statusCode == UNAUTHORIZED || answer.statusCode >= OVERLOADED
                throw PlatformFault("${answer.statusCode}", whole)
            }
            answer
        }

    private fun send(
        request: HTTPRequest,
        leave: String,
    ): HTTPResponse = Outside.send(request.apply { authorization = leave })

    private fun leave(
        platform: Platform,
        scope: String,
    ): String {
        val now = clock.instant()
        val name = "${platform.id} $scope"
        leaves[name]?.takeIf { now < it.until }?.let { return it.header }
        val pair = key.pair
        val assertion =
            PrivateKeyJWT(
                ClientID(platform.clientId),
                platform.token,
                JWSAlgorithm.RS256,
                pair.toPrivateKey(),
                pair.keyID,
                null,
            )
        val request =
            TokenRequest.Builder(platform.token, assertion, ClientCredentialsGrant()).scope(Scope(scope)).build()
        val response = TokenResponse.parse(Outside.send(request.toHTTPRequest()))
        if (!response.indicatesSuccess()) throw PlatformFault("token", asWhole = true)
        val token = response.toSuccessResponse().tokens.accessToken
        val life = Duration.ofSeconds(token.lifetime.coerceIn(0, LONGEST_LEAVE_SECONDS)) - MARGIN
        return "Bearer ${token.value}".also { leaves[name] = Leave(it, now + life) }
    }

    private fun <T> asking(question: () -> T): T =
        try {
            question()
        } catch (failure: IOException) {
            throw PlatformFault("away", asWhole = true, failure)
        } catch (failure: ParseException) {
            throw PlatformFault("token", asWhole = true, failure)
        } catch (failure: JOSEException) {
            throw PlatformFault("token", asWhole = true, failure)
        }

    private fun json(answer: HTTPResponse) =
        try {
            Json.parseToJsonElement(answer.body.orEmpty())
        } catch (failure: SerializationException) {
            throw PlatformFault(UNREADABLE, asWhole = false, failure)
        }

    private fun address(item: JsonObject?): String =
        try {
            item?.text("id")?.takeIf { ProviderSettings.isPrivate(URI(it)) }
                ?: throw PlatformFault(UNREADABLE, asWhole = false)
        } catch (failure: URISyntaxException) {
            throw PlatformFault(UNREADABLE, asWhole = false, failure)
        }

    private fun JsonObject.text(field: String): String? = (get(field) as? JsonPrimitive)?.contentOrNull

    private companion object {
        const val SCORE = LaunchMessage.SCORE
        const val LINE_ITEM = LaunchMessage.LINE_ITEM
        const val SCORE_TYPE = "application/vnd.ims.lis.v1.score+json"
        const val ITEM_TYPE = "application/vnd.ims.lis.v2.lineitem+json"
        const val ITEMS_TYPE = "application/vnd.ims.lis.v2.lineitemcontainer+json"
        const val UNREADABLE = "unreadable"
        const val OK = 200
        const val UNAUTHORIZED = 401
        const val CONFLICT = 409
        const val OVERLOADED = 429
        const val LONGEST_LEAVE_SECONDS = 3600L
        val MARGIN: Duration = Duration.ofSeconds(30)

        fun get(place: String): () -> HTTPRequest =
            { HTTPRequest(HTTPRequest.Method.GET, URI(place)).apply { accept = ITEMS_TYPE } }

        fun post(
            place: String,
            type: String,
            text: String,
        ): () -> HTTPRequest =
            {
                HTTPRequest(HTTPRequest.Method.POST, URI(place)).apply {
                    setContentType(type)
                    body = text
                }
            }
    }
}
