package rasterlab.grader.institution

import com.nimbusds.jose.JOSEException
import com.nimbusds.jose.KeySourceException
import com.nimbusds.jose.jwk.source.JWKSource
import com.nimbusds.jose.proc.BadJOSEException
import com.nimbusds.jose.proc.JWSVerificationKeySelector
import com.nimbusds.jose.proc.SecurityContext
import com.nimbusds.oauth2.sdk.AuthorizationCode
import com.nimbusds.oauth2.sdk.AuthorizationCodeGrant
import com.nimbusds.oauth2.sdk.ParseException
import com.nimbusds.oauth2.sdk.ResponseType
import com.nimbusds.oauth2.sdk.Scope
import com.nimbusds.oauth2.sdk.TokenRequest
import com.nimbusds.oauth2.sdk.auth.ClientAuthenticationMethod
import com.nimbusds.oauth2.sdk.auth.ClientSecretBasic
import com.nimbusds.oauth2.sdk.auth.ClientSecretPost
import com.nimbusds.oauth2.sdk.auth.Secret
import com.nimbusds.oauth2.sdk.id.ClientID
import com.nimbusds.oauth2.sdk.id.Issuer
import com.nimbusds.oauth2.sdk.id.State
import com.nimbusds.oauth2.sdk.pkce.CodeChallengeMethod
import com.nimbusds.oauth2.sdk.pkce.CodeVerifier
import com.nimbusds.oauth2.sdk.token.AccessToken
import com.nimbusds.openid.connect.sdk.AuthenticationRequest
import com.nimbusds.openid.connect.sdk.AuthenticationResponseParser
import com.nimbusds.openid.connect.sdk.Nonce
import com.nimbusds.openid.connect.sdk.OIDCTokenResponse
import com.nimbusds.openid.connect.sdk.OIDCTokenResponseParser
import com.nimbusds.openid.connect.sdk.UserInfoRequest
import com.nimbusds.openid.connect.sdk.UserInfoResponse
import com.nimbusds.openid.connect.sdk.claims.ClaimsSet
import com.nimbusds.openid.connect.sdk.claims.IDTokenClaimsSet
import com.nimbusds.openid.connect.sdk.op.OIDCProviderMetadata
import com.nimbusds.openid.connect.sdk.token.OIDCTokens
import com.nimbusds.openid.connect.sdk.validators.IDTokenValidator
import kotlinx.serialization.Serializable
import java.io.IOException
import java.net.URI
import java.time.Duration
import java.time.Instant
import java.time.InstantSource

/** A sign-in that has begun: what only the provider's answer to this one can fit. */
@Serializable
internal class Begun private constructor(
    val page: String,
    private val stateText: String,
    private val nonceText: String,
    private val verifierText: String,
) {
    val state get() = State(stateText)
    val nonce get() = Nonce(nonceText)
    val verifier get() = CodeVerifier(verifierText)

    companion object {
        fun of(page: String) = Begun(page, State().value, Nonce().value, CodeVerifier().value)
    }
}

/**
 * Asks an OpenID provider who somebody is: authorization code flow with PKCE. Its addresses come from its discovery
 * document, its keys are fetched again where a token names one that is not known yet.
 */
internal class OpenIdProvider(
    private val settings: ProviderSettings,
    private val clock: InstantSource,
) {
    private class Known(
        val metadata: OIDCProviderMetadata,
        val keys: JWKSource<SecurityContext>,
        val until: Instant,
    )

    @Volatile
    private var known: Known? = null
    private val client = ClientID(settings.clientId)

    /** Where people sign in. */
    fun entry(begun: Begun): URI =
        AuthenticationRequest
            .Builder(ResponseType.CODE, scope(), client, settings.redirect)
            .endpointURI(known().metadata.authorizationEndpointURI)
            .state(begun.state)
            .nonce(begun.nonce)
            .codeChallenge(begun.verifier, CodeChallengeMethod.S256)
            .build()
            .toURI()

    /** Where people sign out, once the provider has told it; null where it has not. */
    fun exit(): URI? = known?.metadata?.endSessionEndpointURI

    /**
     * Tells what the provider calls the person.
     *
     * @param answer the parameters with which the provider sent the person back
     * @throws SignInRefused
     */
    fun name(
        begun: Begun,
        answer: Map<String, List<String>>,
    ): String =
        asking {
            val known = known()
            val tokens = tokens(known, begun, code(known, begun, answer))
            val claims = verified(known, tokens, begun)
            named(claims) ?: told(known, claims, tokens.accessToken)?.let(::named)
                ?: throw SignInRefused(SignInFault.NAMELESS, detail = "no claim '${settings.claim}' that counts")
        }

    private fun code(
        known: Known,
        begun: Begun,
        answer: Map<String, List<String>>,
    ): AuthorizationCode {
        if (answer.values.any { it.size != 1 }) throw SignInRefused(SignInFault.STALE)
        val response = AuthenticationResponseParser.parse(settings.redirect, answer)
        if (response.state != begun.state) throw SignInRefused(SignInFault.STALE)
        val issuer = response.issuer
        val told = issuer != null || known.metadata.supportsAuthorizationResponseIssuerParam()
        if (told && issuer != known.metadata.issuer) {
            throw SignInRefused(SignInFault.UNTRUSTED, detail = "the answer comes from another issuer")
        }
        if (!response.indicatesSuccess()) {
            val error = response.toErrorResponse().errorObject?.code
            throw SignInRefused(SignInFault.DENIED, detail = "the provider answered '$error'")
        }
        return response.toSuccessResponse().authorizationCode
            ?: throw SignInRefused(SignInFault.UNTRUSTED, detail = "the answer has no code")
    }

    private fun tokens(
        known: Known,
        begun: Begun,
        code: AuthorizationCode,
    ): OIDCTokens {
        val grant = AuthorizationCodeGrant(code, settings.redirect, begun.verifier)
        val place = known.metadata.tokenEndpointURI
        val request =
            when (val secret = settings.secret?.let(::Secret)) {
                null -> TokenRequest.Builder(place, client, grant)
                else -> TokenRequest.Builder(place, authentication(known, secret), grant)
            }
        val response = OIDCTokenResponseParser.parse(Outside.send(request.build().toHTTPRequest()))
        if (response is OIDCTokenResponse) return response.oidcTokens
        val error = response.toErrorResponse().errorObject?.code
        throw SignInRefused(SignInFault.UNTRUSTED, detail = "the provider gives no token: '$error'")
    }

    private fun authentication(
        known: Known,
        secret: Secret,
    ) = known.metadata.tokenEndpointAuthMethods.orEmpty().let {
        val posts = ClientAuthenticationMethod.CLIENT_SECRET_POST in it
        val plain = it.isEmpty() || ClientAuthenticationMethod.CLIENT_SECRET_BASIC in it
        if (posts && !plain) ClientSecretPost(client, secret) else ClientSecretBasic(client, secret)
    }

    private fun verified(
        known: Known,
        tokens: OIDCTokens,
        begun: Begun,
    ): IDTokenClaimsSet {
        val selector = JWSVerificationKeySelector(Outside.SIGNATURES, known.keys)
        val token = tokens.idToken ?: throw SignInRefused(SignInFault.UNTRUSTED, detail = "there is no ID token")
        return IDTokenValidator(known.metadata.issuer, client, selector, null).validate(token, begun.nonce)
    }

    /** Asks what the provider tells of the same person beside the token; null where it tells nothing. */
    private fun told(
        known: Known,
        claims: IDTokenClaimsSet,
        access: AccessToken?,
    ): ClaimsSet? {
        val place = known.metadata.userInfoEndpointURI
        if (place == null || access == null || !ProviderSettings.isPrivate(place)) return null
        val response = UserInfoResponse.parse(Outside.send(UserInfoRequest(place, access).toHTTPRequest()))
        if (!response.indicatesSuccess()) return null
        val told = response.toSuccessResponse().userInfo ?: return null
        if (told.subject != claims.subject) {
            throw SignInRefused(SignInFault.UNTRUSTED, detail = "what is told beside the token is of somebody else")
        }
        return told
    }

    private fun named(claims: ClaimsSet): String? {
        if (settings.claim == ProviderSettings.EMAIL && claims.getClaim("email_verified") != true) return null
        val value = claims.getClaim(settings.claim)
        val text = if (value is Long || value is Int) value.toString() else value as? String
        return text?.takeIf { it.isNotBlank() && it.length <= LONGEST_NAME }
    }

    private fun scope() =
        when (settings.claim) {
            "sub" -> Scope("openid")
            ProviderSettings.EMAIL -> Scope("openid", "email")
            else -> Scope("openid", "profile", "email")
        }

    @Synchronized
    private fun known(): Known {
        val now = clock.instant()
        return known?.takeIf { now < it.until } ?: asking { discover(now) }.also { known = it }
    }

    private fun discover(now: Instant): Known {
        val place = URI("${settings.issuer.toString().trimEnd('/')}/.well-known/openid-configuration")
        val metadata = OIDCProviderMetadata.parse(Outside.retriever().retrieveResource(place.toURL()).content)
        val addresses =
            listOf(metadata.authorizationEndpointURI, metadata.tokenEndpointURI, metadata.jwkSetURI)
        when {
            metadata.issuer != Issuer(settings.issuer) -> {
                throw SignInRefused(
                    SignInFault.UNTRUSTED,
                    detail = "discovery is of another issuer, ${metadata.issuer}",
                )
            }

            addresses.any { it == null || !ProviderSettings.isPrivate(it) } -> {
                throw SignInRefused(SignInFault.UNTRUSTED, detail = "discovery has an address without encryption")
            }
        }
        return Known(metadata, Outside.keys(metadata.jwkSetURI), now + KNOWN_FOR)
    }

    private fun <T> asking(question: () -> T): T =
        try {
            question()
        } catch (failure: IOException) {
            throw SignInRefused(SignInFault.AWAY, detail = "the provider does not answer", cause = failure)
        } catch (failure: KeySourceException) {
            throw SignInRefused(SignInFault.AWAY, detail = "the provider's keys cannot be had", cause = failure)
        } catch (failure: ParseException) {
            throw SignInRefused(SignInFault.UNTRUSTED, detail = "the provider's answer cannot be read", cause = failure)
        } catch (failure: BadJOSEException) {
            throw SignInRefused(SignInFault.UNTRUSTED, detail = "the token does not hold", cause = failure)
        } catch (failure: JOSEException) {
            throw SignInRefused(SignInFault.UNTRUSTED, detail = "the token cannot be checked", cause = failure)
        }

    private companion object {
        const val LONGEST_NAME = 254
        val KNOWN_FOR: Duration = Duration.ofHours(1)
    }
}
