package rasterlab.grader.institution

import com.nimbusds.jose.JWSAlgorithm
import com.nimbusds.jose.jwk.source.JWKSource
import com.nimbusds.jose.jwk.source.JWKSourceBuilder
import com.nimbusds.jose.proc.SecurityContext
import com.nimbusds.jose.util.DefaultResourceRetriever
import com.nimbusds.oauth2.sdk.http.HTTPRequest
import com.nimbusds.oauth2.sdk.http.HTTPResponse
import java.net.URI

/** How this server asks services of institutions: not for long, not for much, and nowhere that they only point to. */
internal object Outside {
    private const val PATIENCE_MILLIS = 5_000
    private const val MOST_BYTES = 256 * 1024

    /** The signatures that a public key checks: with a shared secret, or none, anybody could sign. */
    val SIGNATURES: Set<JWSAlgorithm> =
        JWSAlgorithm.Family.RSA + JWSAlgorithm.Family.EC.filter { it != JWSAlgorithm.ES256K }

    fun retriever() = DefaultResourceRetriever(PATIENCE_MILLIS, PATIENCE_MILLIS, MOST_BYTES)

    /** The keys that are published at [place]; fetched again where a token names one that is not known yet. */
    fun keys(place: URI): JWKSource<SecurityContext> =
        JWKSourceBuilder
            .create<SecurityContext>(place.toURL(), retriever())
            .refreshAheadCache(false)
            .build()

    fun send(request: HTTPRequest): HTTPResponse =
        request
            .apply {
                connectTimeout = PATIENCE_MILLIS
                readTimeout = PATIENCE_MILLIS
                followRedirects = false
            }.send()
}
