// Sign-in by the institution that a course belongs to. Start with InstitutionSignIn.
package rasterlab.grader.institution

import java.net.URI

/**
 * How people are recognised whom the institution has signed in.
 *
 * @param provider speaks OpenID Connect; null where a proxy's header names the person
 * @param header of a trusted proxy; null where the provider names the person
 * @param column of the roster that holds what the institution calls a student
 * @param staff what the institution calls instructors and assistants, with their ids
 */
class InstitutionSettings(
    val provider: ProviderSettings?,
    val header: String?,
    val column: String,
    val staff: Map<String, String>,
)

/**
 * A provider of OpenID Connect, and what this server is to it. It is no data class: one would print the secret.
 *
 * @param secret null for a client without one, which PKCE alone protects
 * @param redirect where the provider sends people back to
 * @param claim of the ID token that names a person
 */
class ProviderSettings(
    val issuer: URI,
    val clientId: String,
    val secret: String?,
    val redirect: URI,
    val claim: String,
) {
    companion object {
        /** The claim with a person's address, which counts only where the provider has verified it. */
        const val EMAIL = "email"

        /** Whether what is sent there stays between the two: it is encrypted, or stays on this machine. */
        fun isPrivate(address: URI): Boolean =
            address.host != null &&
                (address.scheme == "https" || (address.scheme == "http" && address.host in THIS_MACHINE))

        private val THIS_MACHINE = setOf("127.0.0.1", "localhost", "[::1]")
    }
}
