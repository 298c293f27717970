package rasterlab.grader

import picocli.CommandLine.Option
import rasterlab.grader.institution.InstitutionSettings
import rasterlab.grader.institution.InstitutionSignIn
import rasterlab.grader.institution.ProviderSettings
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.web.institution.INSTITUTION_BACK
import java.io.IOException
import java.net.URI
import java.net.URISyntaxException
import java.nio.file.Files
import java.nio.file.Path

/** The options of `serve` for sign-in by the institution. */
internal class InstitutionOptions {
    @Option(
        names = ["--public-address"],
        paramLabel = "URL",
        description = ["Address of this server as browsers have it, such as https://grader.example.org."],
    )
    var publicAddress: String? = null

    @Option(
        names = ["--oidc-issuer"],
        paramLabel = "URL",
        description = [
            "OpenID provider that people may sign in with, such as https://login.example.org.",
            "It is to send them back to /sign-in/institution/back below the public address.",
        ],
    )
    var issuer: String? = null

    @Option(
        names = ["--oidc-client-id"],
        paramLabel = "ID",
        description = ["What that provider calls this server."],
    )
    var clientId: String? = null

    @Option(
        names = ["--oidc-client-secret"],
        paramLabel = "FILE",
        description = ["File with the secret that the provider gave this server, if it gave one."],
    )
    var secret: Path? = null

    @Option(
        names = ["--oidc-claim"],
        paramLabel = "NAME",
        defaultValue = "sub",
        description = [
            "What of the provider's word names a person; default: \${DEFAULT-VALUE}.",
            "'email' counts only where the provider has verified it.",
        ],
    )
    var claim = "sub"

    @Option(
        names = ["--sign-in-header"],
        paramLabel = "NAME",
        description = [
            "Header in which the proxies of --proxy name who has signed in there, such as X-Remote-User.",
            "They must take it out of what browsers send.",
        ],
    )
    var header: String? = null

    @Option(
        names = ["--sign-in-column"],
        paramLabel = "NAME",
        defaultValue = "username",
        description = [
            "Column of the roster with that name of a student: id-number, sis-user-id, sis-login-id,",
            "username or email; default: \${DEFAULT-VALUE}.",
        ],
    )
    var column = "username"

    @Option(
        names = ["--sign-in-staff"],
        paramLabel = "FILE",
        description = [
            "File with a line for each instructor and assistant who signs in so:",
            "that name, a space, and the id that ./lab grader staff list shows.",
            "It is read at the start.",
        ],
    )
    var staff: Path? = null

    /** Reads what the options ask for; null where nobody signs in so. */
    fun settings(proxied: Boolean): InstitutionSettings? {
        val named = issuer ?: header
        if (issuer != null && header != null) throw CannotStart(StartFailure.SIGN_IN_BOTH)
        listOf("oidc-client-id" to clientId, "oidc-client-secret" to secret).forEach { (option, value) ->
            if (value != null && issuer == null) throw CannotStart(StartFailure.SIGN_IN_ALONE, option, "--oidc-issuer")
        }
        if (staff != null && named == null) {
            throw CannotStart(StartFailure.SIGN_IN_ALONE, "sign-in-staff", "--oidc-issuer / --sign-in-header")
        }
        if (header != null && !proxied) throw CannotStart(StartFailure.SIGN_IN_ALONE, "sign-in-header", "--proxy")
        if (header?.let { HEADER.matches(it) } ==
            false
        ) {
            throw CannotStart(StartFailure.SIGN_IN_HEADER, header.orEmpty())
        }
        if (column !in InstitutionSignIn.COLUMNS) {
            throw CannotStart(StartFailure.SIGN_IN_COLUMN, column, InstitutionSignIn.COLUMNS.joinToString())
        }
        val public = public()
        if (named == null) return null
        return InstitutionSettings(provider(public), header, column, staffOf())
    }

    /** The address of the server as browsers have it; null where it is not told. */
    fun public(): URI? = publicAddress?.let { address("public-address", it) }

    private fun provider(public: URI?): ProviderSettings? {
        val place = address("oidc-issuer", issuer ?: return null)
        val client = clientId ?: throw CannotStart(StartFailure.SIGN_IN_ALONE, "oidc-issuer", "--oidc-client-id")
        public ?: throw CannotStart(StartFailure.SIGN_IN_ALONE, "oidc-issuer", "--public-address")
        val back = URI("${public.toString().trimEnd('/')}$INSTITUTION_BACK")
        return ProviderSettings(place, client, secret?.let(::secretOf), back, claim)
    }

    private fun address(
        option: String,
        text: String,
    ): URI {
        val address =
            try {
                URI(text)
            } catch (failure: URISyntaxException) {
                throw CannotStart(StartFailure.SIGN_IN_ADDRESS, option, text, cause = failure)
            }
        if (!ProviderSettings.isPrivate(address) ||
            listOf(address.query, address.fragment, address.userInfo).any { it != null }
        ) {
            throw CannotStart(StartFailure.SIGN_IN_ADDRESS, option, text)
        }
        return address
    }

    private fun secretOf(file: Path): String =
        lines(file).singleOrNull()?.trim()?.takeIf { it.isNotEmpty() }
            ?: throw CannotStart(StartFailure.SIGN_IN_SECRET, file)

    private fun staffOf(): Map<String, String> {
        val file = staff ?: return emptyMap()
        val found = mutableMapOf<String, String>()
        lines(file).forEachIndexed { index, line ->
            val text = line.trim()
            if (text.isEmpty() || text.startsWith('#')) return@forEachIndexed
            val name = InstitutionSignIn.key(column, text.substringBeforeLast(' ').trim())
            if (' ' !in text || found.put(name, text.substringAfterLast(' ')) != null) {
                throw CannotStart(StartFailure.SIGN_IN_STAFF, file, index + 1)
            }
        }
        return found
    }

    private fun lines(file: Path): List<String> =
        try {
            Files.readString(file).trimEnd('\n', '\r').lines()
        } catch (failure: IOException) {
            throw CannotStart(StartFailure.SIGN_IN_FILE, file, failure.reason(), cause = failure)
        }

    private companion object {
        val HEADER = Regex("[A-Za-z0-9-]+")
    }
}
