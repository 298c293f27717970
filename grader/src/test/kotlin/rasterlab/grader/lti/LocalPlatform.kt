package rasterlab.grader.lti

import com.nimbusds.jose.JWSAlgorithm
import com.nimbusds.jose.JWSHeader
import com.nimbusds.jose.crypto.RSASSASigner
import com.nimbusds.jose.crypto.RSASSAVerifier
import com.nimbusds.jose.jwk.JWKSet
import com.nimbusds.jose.jwk.RSAKey
import com.nimbusds.jose.jwk.gen.RSAKeyGenerator
import com.nimbusds.jwt.JWT
import com.nimbusds.jwt.JWTClaimsSet
import com.nimbusds.jwt.SignedJWT
import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import io.ktor.http.Parameters
import io.ktor.http.parseQueryString
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.URI
import java.time.Instant
import java.util.Date
import java.util.UUID
import java.util.concurrent.CopyOnWriteArrayList

/**
 * A learning platform on this machine, by the messages of LTI 1.3 Advantage: it signs in [person] without a question,
 * keeps line items, and takes scores from whoever has the key that the tool publishes. Tests make it lie, refuse or be
 * away by its fields.
 */
class LocalPlatform : AutoCloseable {
    /** @param path of the line item, with `/scores` behind it */
    class Taken(
        val path: String,
        val score: JsonObject,
    )

    private var server = listening(0)
    val port = server.address.port
    val issuer = "http://127.0.0.1:$port"

    var person = "ada-there"
    var roles = listOf("$MEMBERSHIP#Learner")
    var keys: RSAKey = FIRST
    var claims: JWTClaimsSet.Builder.() -> Unit = {}
    var token: (JWTClaimsSet) -> JWT = { signed(keys, it) }
    var toolKeys: () -> JWKSet = { error("the platform has not read the tool's keys") }
    var status = 200
    val taken = CopyOnWriteArrayList<Taken>()

    /** Done for each score that was taken. */
    var onScore = {}
    val lineItems = CopyOnWriteArrayList<String>()
    val leaves = CopyOnWriteArrayList<String>()

    fun form(makesStaff: Boolean = false) =
        PlatformForm("Moodle", issuer, CLIENT, "1", "$issuer/auth?realm=1", "$issuer/token", "$issuer/jwks", makesStaff)

    /** Answers an authentication request, as the form that the browser carries back. */
    fun answer(asked: URI): Parameters {
        val request = parseQueryString(asked.rawQuery)
        val expected =
            mapOf(
                "scope" to "openid",
                "response_type" to "id_token",
                "response_mode" to "form_post",
                "prompt" to "none",
                "client_id" to CLIENT,
                "redirect_uri" to "http://localhost/lti/launch",
                "login_hint" to "hint",
                "lti_message_hint" to "message",
                "realm" to "1",
            )
        val told = expected.mapValues { request[it.key] }
        check(told == expected) { "the tool asks $told" }
        val claims = claimsOf(checkNotNull(request["nonce"]))
        return Parameters.build {
            append("id_token", token(claims).serialize())
            append("state", checkNotNull(request["state"]))
        }
    }

    private fun claimsOf(nonce: String): JWTClaimsSet {
        val now = System.currentTimeMillis()
        return JWTClaimsSet
            .Builder()
            .issuer(issuer)
            .subject(person)
            .audience(CLIENT)
            .issueTime(Date(now))
            .expirationTime(Date(now + 60_000))
            .claim("nonce", nonce)
            .claim("name", "Ada Lovelace")
            .claim("${LTI}deployment_id", "1")
            .claim("${LTI}version", "1.3.0")
            .claim("${LTI}message_type", "LtiResourceLinkRequest")
            .claim("${LTI}roles", roles)
            .claim("${LTI}context", mapOf("id" to "course-7", "title" to "Graphics there"))
            .claim("${LTI}resource_link", mapOf("id" to "link-1"))
            .claim("${LTI}custom", mapOf("exercise" to "draw-dot"))
            .claim(
                "https://purl.imsglobal.org/spec/lti-ags/claim/endpoint",
                mapOf(
                    "scope" to listOf("$AGS/lineitem", "$AGS/score"),
                    "lineitem" to "$issuer/items/1/lineitem?type=7",
                    "lineitems" to "$issuer/items",
                ),
            ).apply(claims)
            .build()
    }

    /** Ends, or begins again at the same address. */
    fun away(gone: Boolean) {
        if (gone) server.stop(0) else server = listening(port)
    }

    private fun listening(at: Int): HttpServer =
        HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), at), 0).apply {
            createContext("/") { exchange -> exchange.use { answer(it) } }
            start()
        }

    private fun answer(exchange: HttpExchange) =
        with(exchange) {
            val path = requestURI.path
            when {
                path == "/jwks" -> json(200, JWKSet(keys.toPublicJWK()).toString())
                path == "/token" -> leave()
                requestHeaders.getFirst("Authorization")?.removePrefix("Bearer ") !in leaves -> json(401, "{}")
                path == "/items" && requestMethod == "GET" -> json(200, lineItems.toString())
                path == "/items" -> newItem()
                path.endsWith("/scores") -> score()
                else -> json(404, "{}")
            }
        }

    private fun HttpExchange.leave() {
        val form = parseQueryString(requestBody.readBytes().decodeToString())
        val assertion = SignedJWT.parse(form["client_assertion"])
        val key = toolKeys().getKeyByKeyId(assertion.header.keyID).toRSAKey()
        val claims = assertion.jwtClaimsSet
        val fits =
            form["grant_type"] == "client_credentials" &&
                form["client_assertion_type"] == "urn:ietf:params:oauth:client-assertion-type:jwt-bearer" &&
                form["scope"] in setOf("$AGS/score", "$AGS/lineitem") &&
                assertion.verify(RSASSAVerifier(key)) &&
                claims.issuer == CLIENT &&
                claims.subject == CLIENT &&
                claims.audience == listOf("$issuer/token") &&
                claims.expirationTime.toInstant() > Instant.now() &&
                claims.jwtid != null
        if (!fits) return json(400, """{"error":"invalid_client"}""")
        val leave = UUID.randomUUID().toString().also { leaves += it }
        json(200, """{"access_token":"$leave","token_type":"Bearer","expires_in":3600,"scope":"${form["scope"]}"}""")
    }

    private fun HttpExchange.newItem() {
        val wanted = Json.parseToJsonElement(requestBody.readBytes().decodeToString()).jsonObject
        val place = "$issuer/items/${lineItems.size + 100}"
        val made = JsonObject(wanted + ("id" to JsonPrimitive(place)))
        lineItems += "$made"
        json(201, "$made")
    }

    private fun HttpExchange.score() {
        val body = requestBody.readBytes().decodeToString()
        val isScore = requestHeaders.getFirst("Content-Type").startsWith("application/vnd.ims.lis.v1.score+json")
        if (!isScore) return json(415, "{}")
        if (status in 200..299) {
            taken += Taken("$requestURI", Json.parseToJsonElement(body).jsonObject)
            onScore()
        }
        json(status, "{}")
    }

    private fun HttpExchange.json(
        status: Int,
        body: String,
    ) {
        responseHeaders.add("Content-Type", "application/json")
        sendResponseHeaders(status, body.toByteArray().size.toLong())
        responseBody.write(body.toByteArray())
    }

    override fun close() = server.stop(0)

    companion object {
        const val CLIENT = "rasterlab-client"
        const val LTI = "https://purl.imsglobal.org/spec/lti/claim/"
        const val AGS = "https://purl.imsglobal.org/spec/lti-ags/scope"
        const val DEEP_LINKING = "https://purl.imsglobal.org/spec/lti-dl/claim/"
        const val MEMBERSHIP = "http://purl.imsglobal.org/vocab/lis/v2/membership"

        private val FIRST: RSAKey by lazy { key() }

        fun key(): RSAKey = RSAKeyGenerator(2048).keyIDFromThumbprint(true).generate()

        fun signed(
            key: RSAKey,
            claims: JWTClaimsSet,
        ): JWT =
            SignedJWT(JWSHeader.Builder(JWSAlgorithm.RS256).keyID(key.keyID).build(), claims)
                .apply { sign(RSASSASigner(key)) }
    }
}

private inline fun HttpExchange.use(work: (HttpExchange) -> Unit) =
    try {
        work(this)
    } finally {
        close()
    }
