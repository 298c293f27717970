package rasterlab.grader.institution

import com.nimbusds.jose.JWSAlgorithm
import com.nimbusds.jose.JWSHeader
import com.nimbusds.jose.crypto.RSASSASigner
import com.nimbusds.jose.jwk.JWKSet
import com.nimbusds.jose.jwk.RSAKey
import com.nimbusds.jose.jwk.gen.RSAKeyGenerator
import com.nimbusds.jwt.JWT
import com.nimbusds.jwt.JWTClaimsSet
import com.nimbusds.jwt.PlainJWT
import com.nimbusds.jwt.SignedJWT
import com.nimbusds.oauth2.sdk.AuthorizationCode
import com.nimbusds.oauth2.sdk.AuthorizationCodeGrant
import com.nimbusds.oauth2.sdk.OAuth2Error
import com.nimbusds.oauth2.sdk.TokenErrorResponse
import com.nimbusds.oauth2.sdk.TokenRequest
import com.nimbusds.oauth2.sdk.auth.ClientSecretBasic
import com.nimbusds.oauth2.sdk.http.HTTPRequest
import com.nimbusds.oauth2.sdk.id.Issuer
import com.nimbusds.oauth2.sdk.pkce.CodeChallenge
import com.nimbusds.oauth2.sdk.pkce.CodeChallengeMethod
import com.nimbusds.oauth2.sdk.token.BearerAccessToken
import com.nimbusds.openid.connect.sdk.AuthenticationRequest
import com.nimbusds.openid.connect.sdk.OIDCTokenResponse
import com.nimbusds.openid.connect.sdk.SubjectType
import com.nimbusds.openid.connect.sdk.op.OIDCProviderMetadata
import com.nimbusds.openid.connect.sdk.token.OIDCTokens
import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.URI
import java.util.Date
import java.util.UUID
import java.util.concurrent.ConcurrentHashMap

/** An OpenID provider on this machine, which signs in [person] without a question; tests make it lie by its fields. */
class LocalProvider : AutoCloseable {
    private class Asked(
        val request: AuthenticationRequest,
        val person: String,
    )

    private val server = HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0)
    private val codes = ConcurrentHashMap<String, Asked>()
    val issuer = URI("http://127.0.0.1:${server.address.port}")

    var person = "ada"
    var keys: RSAKey = key()
    var publishes: RSAKey? = null
    var says: Issuer = Issuer(issuer)
    var claims: JWTClaimsSet.Builder.() -> Unit = {}
    var token: (JWTClaimsSet) -> JWT = { signed(keys, it) }

    init {
        answer("/.well-known/openid-configuration") { json(200, metadata().toJSONObject().toString()) }
        answer("/jwks") { json(200, JWKSet((publishes ?: keys).toPublicJWK()).toString()) }
        answer("/authorize") { authorize() }
        answer("/token") { token() }
        server.start()
    }

    fun settings(claim: String = "sub") =
        ProviderSettings(issuer, CLIENT, SECRET, URI("http://localhost/sign-in/institution/back"), claim)

    private fun metadata() =
        OIDCProviderMetadata(says, listOf(SubjectType.PUBLIC), URI("$issuer/jwks")).apply {
            authorizationEndpointURI = URI("$issuer/authorize")
            tokenEndpointURI = URI("$issuer/token")
            applyDefaults()
        }

    private fun HttpExchange.authorize() {
        val asked = AuthenticationRequest.parse(requestURI)
        check(asked.codeChallengeMethod == CodeChallengeMethod.S256 && asked.redirectionURI == settings().redirect)
        val code = UUID.randomUUID().toString()
        codes[code] = Asked(asked, person)
        responseHeaders.add("Location", "${asked.redirectionURI}?code=$code&state=${asked.state}")
        sendResponseHeaders(302, -1)
    }

    private fun HttpExchange.token() {
        val http = HTTPRequest(HTTPRequest.Method.POST, URI("$issuer/token"))
        http.setHeader("Content-Type", requestHeaders.getFirst("Content-Type"))
        http.setHeader("Authorization", requestHeaders.getFirst("Authorization"))
        http.body = requestBody.readBytes().decodeToString()
        val request = TokenRequest.parse(http)
        val client = request.clientAuthentication as ClientSecretBasic
        val grant = request.authorizationGrant as AuthorizationCodeGrant
        val asked = codes.remove((grant.authorizationCode as AuthorizationCode).value)
        val challenge = grant.codeVerifier?.let { CodeChallenge.compute(CodeChallengeMethod.S256, it) }
        val response =
            if (client.clientSecret.value != SECRET || asked == null || asked.request.codeChallenge != challenge) {
                TokenErrorResponse(OAuth2Error.INVALID_GRANT)
            } else {
                OIDCTokenResponse(OIDCTokens(token(claimsOf(asked)), BearerAccessToken(), null))
            }.toHTTPResponse()
        json(response.statusCode, response.body)
    }

    private fun claimsOf(asked: Asked): JWTClaimsSet {
        val now = System.currentTimeMillis()
        return JWTClaimsSet
            .Builder()
            .issuer("$issuer")
            .subject(asked.person)
            .audience(CLIENT)
            .issueTime(Date(now))
            .expirationTime(Date(now + 60_000))
            .claim("nonce", asked.request.nonce.value)
            .apply(claims)
            .build()
    }

    private fun answer(
        path: String,
        work: HttpExchange.() -> Unit,
    ) = server.createContext(path) { exchange -> exchange.use { it.work() } }

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
        const val CLIENT = "rasterlab"
        const val SECRET = "a-secret-that-nobody-may-read"

        fun key(): RSAKey = RSAKeyGenerator(2048).keyIDFromThumbprint(true).generate()

        fun signed(
            key: RSAKey,
            claims: JWTClaimsSet,
        ): JWT =
            SignedJWT(JWSHeader.Builder(JWSAlgorithm.RS256).keyID(key.keyID).build(), claims)
                .apply { sign(RSASSASigner(key)) }

        fun unsigned(claims: JWTClaimsSet): JWT = PlainJWT(claims)
    }
}

private inline fun HttpExchange.use(work: (HttpExchange) -> Unit) =
    try {
        work(this)
    } finally {
        close()
    }
