package rasterlab.grader.lti

import com.nimbusds.jose.JOSEException
import com.nimbusds.jose.KeySourceException
import com.nimbusds.jose.jwk.source.JWKSource
import com.nimbusds.jose.proc.BadJOSEException
import com.nimbusds.jose.proc.JWSVerificationKeySelector
import com.nimbusds.jose.proc.SecurityContext
import com.nimbusds.jwt.JWTClaimsSet
import com.nimbusds.jwt.JWTParser
import com.nimbusds.oauth2.sdk.ResponseMode
import com.nimbusds.oauth2.sdk.ResponseType
import com.nimbusds.oauth2.sdk.Scope
import com.nimbusds.oauth2.sdk.id.ClientID
import com.nimbusds.oauth2.sdk.id.Issuer
import com.nimbusds.oauth2.sdk.id.State
import com.nimbusds.openid.connect.sdk.AuthenticationRequest
import com.nimbusds.openid.connect.sdk.Nonce
import com.nimbusds.openid.connect.sdk.Prompt
import com.nimbusds.openid.connect.sdk.validators.IDTokenValidator
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import rasterlab.grader.institution.Outside
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.OnceOnly
import rasterlab.grader.storage.Secrets
import java.net.URI
import java.text.ParseException
import java.time.InstantSource
import java.util.concurrent.ConcurrentHashMap

/**
 * A platform's wish to send somebody here.
 *
 * @param hint by which it knows its person again
 * @param message by which it knows again what the person wants; null where it does not tell
 */
class LoginWish(
    val issuer: String,
    val hint: String,
    val clientId: String?,
    val deployment: String?,
    val message: String?,
)

/**
 * A launch that goes on at the platform.
 *
 * @param state names it, and comes back
 * @param browser a secret that the browser keeps until then
 */
class LaunchErrand(
    val place: URI,
    val state: String,
    val browser: String,
)

/** The beginning of a launch, which only the platform's answer to it can fit. */
@Serializable
private class BegunLaunch(
    val issuer: String,
    val clientId: String,
    val nonce: String,
    val browserHash: String,
)

/** Checks whom a platform sends: the beginning of a launch, and the signed message at its end. */
class Launches(
    private val platforms: Platforms,
    database: Database,
    clock: InstantSource,
) {
    private val begun = OnceOnly(database, clock, "lti")
    private val known = ConcurrentHashMap<URI, JWKSource<SecurityContext>>()

    /**
     * Begins a launch.
     *
     * @param back where the platform is to send its message
     * @throws LtiRefused
     */
    fun begin(
        wish: LoginWish,
        back: URI,
    ): LaunchErrand {
        val platform =
            platforms
                .named(wish.issuer, wish.clientId, wish.deployment)
                .distinctBy { it.clientId }
                .singleOrNull()
                ?: throw LtiRefused(LtiFault.UNKNOWN_PLATFORM, "issuer '${wish.issuer}', client '${wish.clientId}'")
        val nonce = Secrets.newToken()
        val browser = Secrets.newToken()
        val kept = BegunLaunch(platform.issuer, platform.clientId, nonce, Secrets.hash(browser))
        val state = begun.keep(Json.encodeToString(kept))
        val request =
            AuthenticationRequest
                .Builder(ResponseType.IDTOKEN, Scope("openid"), ClientID(platform.clientId), back)
                .endpointURI(platform.login)
                .responseMode(ResponseMode.FORM_POST)
                .prompt(Prompt(Prompt.Type.NONE))
                .state(State(state))
                .nonce(Nonce(nonce))
                .loginHint(wish.hint)
        wish.message?.let { request.customParameter("lti_message_hint", it) }
        return LaunchErrand(request.build().toURI(), state, browser)
    }

    /**
     * Ends what this browser began.
     *
     * @param browser the secret that it kept; null where it has none
     * @param answer the fields of the platform's form
     * @throws LtiRefused
     */
    suspend fun finish(
        browser: String?,
        answer: Map<String, List<String>>,
    ): Launch =
        withContext(ELSEWHERE) {
            val state = answer.single("state") ?: throw LtiRefused(LtiFault.STALE)
            val kept = begun.take(state) ?: throw LtiRefused(LtiFault.STALE)
            val sent = Json.decodeFromString<BegunLaunch>(kept)
            if (browser == null) throw LtiRefused(LtiFault.NO_COOKIE)
            if (Secrets.hash(browser) != sent.browserHash) throw LtiRefused(LtiFault.STALE, "another browser began it")
            answer.single("error")?.let { throw LtiRefused(LtiFault.DENIED, "the platform answers '$it'") }
            val token = answer.single("id_token") ?: throw LtiRefused(LtiFault.MESSAGE, "no id_token")
            val registered = platforms.of(sent.issuer, sent.clientId)
            val first = registered.firstOrNull() ?: throw LtiRefused(LtiFault.UNKNOWN_PLATFORM)
            val message = LaunchMessage(verified(first, token, Nonce(sent.nonce)))
            val deployment = message.deployment
            val platform =
                registered.firstOrNull { it.deployment == deployment }
                    ?: throw LtiRefused(LtiFault.DEPLOYMENT, "deployment '$deployment'")
            message.launch(platform.id)
        }

    private fun verified(
        platform: Platform,
        token: String,
        nonce: Nonce,
    ): JWTClaimsSet =
        try {
            val keys = known.computeIfAbsent(platform.keys, Outside::keys)
            val selector = JWSVerificationKeySelector(Outside.SIGNATURES, keys)
            val client = ClientID(platform.clientId)
            val claims =
                IDTokenValidator(Issuer(platform.issuer), client, selector, null)
                    .validate(JWTParser.parse(token), nonce)
                    .toJWTClaimsSet()
            requireParty(claims, platform.clientId)
            claims
        } catch (failure: KeySourceException) {
            throw LtiRefused(LtiFault.AWAY, "the platform's keys cannot be had", failure)
        } catch (failure: BadJOSEException) {
            val why = if (failure.message == EXPIRED) LtiFault.EXPIRED else LtiFault.UNTRUSTED
            throw LtiRefused(why, "the message does not hold", failure)
        } catch (failure: JOSEException) {
            throw LtiRefused(LtiFault.UNTRUSTED, "the message cannot be checked", failure)
        } catch (failure: ParseException) {
            throw LtiRefused(LtiFault.UNTRUSTED, "the message cannot be read", failure)
        } catch (failure: com.nimbusds.oauth2.sdk.ParseException) {
            throw LtiRefused(LtiFault.UNTRUSTED, "the message lacks what each has", failure)
        }

    /** A message for several, or one that names a party, has to name this server as the one that it was made for. */
    private fun requireParty(
        claims: JWTClaimsSet,
        client: String,
    ) {
        val party = claims.getStringClaim("azp")
        if ((claims.audience.size > 1 || party != null) && party != client) {
            throw LtiRefused(LtiFault.UNTRUSTED, "the message was made for '$party'")
        }
    }

    private fun Map<String, List<String>>.single(name: String): String? = get(name)?.singleOrNull()

    private companion object {
        /** The words of the library for a message whose time is over. */
        const val EXPIRED = "Expired JWT"

        /** Waits for platforms, on threads of its own: one that hangs holds up nobody else's request. */
        val ELSEWHERE = Dispatchers.IO.limitedParallelism(16)
    }
}
