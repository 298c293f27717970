package rasterlab.grader.lti

import com.nimbusds.jwt.JWTClaimsSet
import kotlinx.serialization.Serializable
import rasterlab.grader.institution.ProviderSettings
import java.net.URI
import java.net.URISyntaxException
import java.text.ParseException

/** The part that a platform gives a person in one of its courses. */
enum class LaunchRole {
    LEARNER,
    ASSISTANT,
    INSTRUCTOR,
    ;

    internal companion object {
        private const val MEMBERSHIP = "http://purl.imsglobal.org/vocab/lis/v2/membership"

        /** The role in the course itself; of several, an assistant's goes before an instructor's, which has more rights. */
        fun of(roles: List<String>): LaunchRole? =
            when {
                roles.any { it == "TeachingAssistant" || it in ASSISTANTS } -> ASSISTANT
                roles.any { it == "Instructor" || it == "$MEMBERSHIP#Instructor" } -> INSTRUCTOR
                roles.any { it == "Learner" || it == "$MEMBERSHIP#Learner" } -> LEARNER
                else -> null
            }

        private val ASSISTANTS =
            setOf("$MEMBERSHIP/Instructor#TeachingAssistant", "$MEMBERSHIP#TeachingAssistant")
    }
}

/**
 * Where the scores of a link go.
 *
 * @param lineItem null where there is none yet
 * @param lineItems where one can be made; null where that is not allowed
 */
@Serializable
data class ScorePlace(
    val lineItem: String?,
    val lineItems: String?,
)

/**
 * A wish for links to exercises, by deep linking.
 *
 * @param answer where the chosen ones are sent
 * @param data to be sent back as it came
 * @param several whether more than one may be chosen
 * @param scored whether line items may come along
 */
@Serializable
data class LinkWish(
    val answer: String,
    val data: String?,
    val several: Boolean,
    val scored: Boolean,
)

/**
 * A platform's word on a person who comes from it, which was checked.
 *
 * @param platform id of the registration
 * @param subject what it calls the person, for good
 * @param name empty where it does not tell
 * @param number what the institution calls the person; null where it does not tell
 * @param context what it calls its course
 * @param link what it calls the link that was followed; null at deep linking
 * @param exercise that the link names; null where it names none
 * @param from a page of the platform, which may show this server's in a frame; null where it tells none
 */
@Serializable
data class Launch(
    val platform: String,
    val subject: String,
    val name: String,
    val number: String?,
    val role: LaunchRole,
    val context: String,
    val title: String,
    val link: String?,
    val exercise: String?,
    val scores: ScorePlace?,
    val wish: LinkWish?,
    val from: String?,
)

/** Reads the claims of a message whose signature, audience and times are checked already. */
internal class LaunchMessage(
    private val claims: JWTClaimsSet,
) {
    val deployment: String get() = text("${LTI}deployment_id")

    /** @param platform id of the registration of [deployment] */
    fun launch(platform: String): Launch =
        try {
            read(platform)
        } catch (failure: ParseException) {
            throw LtiRefused(LtiFault.MESSAGE, "a claim has another shape: ${failure.message}", failure)
        }

    private fun read(platform: String): Launch {
        if (text("${LTI}version") != "1.3.0") throw LtiRefused(LtiFault.MESSAGE, "another version of LTI")
        val type = text("${LTI}message_type")
        if (type !in setOf(LINK, DEEP)) throw LtiRefused(LtiFault.MESSAGE, "message of the type '$type'")
        val roles = claims.getStringListClaim("${LTI}roles").orEmpty()
        val role = LaunchRole.of(roles) ?: throw LtiRefused(LtiFault.ROLE, "none of the roles $roles counts")
        val context = part("${LTI}context")
        val wish = if (type == DEEP) wish() else null
        if (wish != null && role == LaunchRole.LEARNER) throw LtiRefused(LtiFault.ROLE, "a learner chooses no links")
        return Launch(
            platform,
            id("sub", claims.subject),
            name(),
            (part("${LTI}lis")["person_sourcedid"] as? String)?.takeIf { it.isNotBlank() && it.length <= LONG },
            role,
            id("context.id", context["id"]),
            listOf("title", "label").firstNotNullOfOrNull { context[it] as? String }.orEmpty().take(LONG),
            if (wish == null) id("resource_link.id", part("${LTI}resource_link")["id"]) else null,
            (part("${LTI}custom")["exercise"] as? String)?.take(LONG),
            if (wish == null) scores() else null,
            wish,
            wish?.answer ?: address(part("${LTI}launch_presentation")["return_url"]),
        )
    }

    private fun wish(): LinkWish {
        val settings = part("${DEEP_LINKING}deep_linking_settings")
        val types = (settings["accept_types"] as? List<*>).orEmpty()
        if (RESOURCE !in types) throw LtiRefused(LtiFault.MESSAGE, "the platform takes $types, no '$RESOURCE'")
        val answer = address(settings["deep_link_return_url"])
        return LinkWish(
            answer ?: throw LtiRefused(LtiFault.MESSAGE, "no address to answer to that keeps it private"),
            settings["data"] as? String,
            settings["accept_multiple"] == true,
            settings["accept_lineitem"] != false,
        )
    }

    /** Where scores go, if this server may send any. */
    private fun scores(): ScorePlace? {
        val place = part(ENDPOINT)
        val scopes = (place["scope"] as? List<*>).orEmpty()
        if (SCORE !in scopes) return null
        val made = address(place["lineitem"])
        val among = address(place["lineitems"]).takeIf { LINE_ITEM in scopes }
        return if (made == null && among == null) null else ScorePlace(made, among)
    }

    private fun name(): String {
        val parts = listOf("given_name", "family_name").mapNotNull { claims.getStringClaim(it) }
        return claims.getStringClaim("name") ?: parts.joinToString(" ")
    }

    private fun part(claim: String): Map<String, Any?> = claims.getJSONObjectClaim(claim).orEmpty()

    private fun text(claim: String): String =
        try {
            claims.getStringClaim(claim).orEmpty()
        } catch (failure: ParseException) {
            throw LtiRefused(LtiFault.MESSAGE, "'$claim' is no text", failure)
        }

    private fun id(
        what: String,
        value: Any?,
    ): String =
        (value as? String)?.takeIf { it.length in 1..Platforms.LONGEST }
            ?: throw LtiRefused(LtiFault.MESSAGE, "'$what' is missing or too long")

    /** An address that keeps what is sent there private; null for anything else. */
    private fun address(value: Any?): String? =
        try {
            (value as? String)?.takeIf { ProviderSettings.isPrivate(URI(it)) }
        } catch (failure: URISyntaxException) {
            throw LtiRefused(LtiFault.MESSAGE, "'$value' is no address", failure)
        }

    internal companion object {
        const val LTI = "https://purl.imsglobal.org/spec/lti/claim/"
        const val DEEP_LINKING = "https://purl.imsglobal.org/spec/lti-dl/claim/"
        const val ENDPOINT = "https://purl.imsglobal.org/spec/lti-ags/claim/endpoint"
        const val LINK = "LtiResourceLinkRequest"
        const val DEEP = "LtiDeepLinkingRequest"
        const val RESOURCE = "ltiResourceLink"

        /** The leave to send scores. */
        const val SCORE = "https://purl.imsglobal.org/spec/lti-ags/scope/score"

        /** The leave to make and find line items. */
        const val LINE_ITEM = "https://purl.imsglobal.org/spec/lti-ags/scope/lineitem"
        private const val LONG = 200
    }
}
