package rasterlab.grader.lti

import com.nimbusds.jwt.JWTClaimsSet
import rasterlab.exercises.Exercise
import rasterlab.grader.storage.Secrets
import java.net.URI
import java.time.Instant
import java.time.InstantSource
import java.util.Date

/** Answers platforms that ask for links to exercises, in messages that this server signs. */
class DeepLinks(
    private val platforms: Platforms,
    private val key: ToolKey,
    private val clock: InstantSource,
) {
    /**
     * The signed message with a link to each of the exercises.
     *
     * @param target where the links lead
     * @param language of the titles
     * @throws LtiRefused
     */
    fun answer(
        launch: Launch,
        wish: LinkWish,
        exercises: List<Exercise>,
        target: URI,
        language: String,
    ): String {
        val platform = platforms.find(launch.platform) ?: throw LtiRefused(LtiFault.UNKNOWN_PLATFORM)
        val now = clock.instant()
        val claims =
            claims(platform, now)
                .claim("${LaunchMessage.LTI}message_type", "LtiDeepLinkingResponse")
                .claim("${LaunchMessage.LTI}version", "1.3.0")
                .claim("${LaunchMessage.LTI}deployment_id", platform.deployment)
                .claim(
                    "${LaunchMessage.DEEP_LINKING}content_items",
                    exercises.map { item(it, wish, target, language) },
                )
        wish.data?.let { claims.claim("${LaunchMessage.DEEP_LINKING}data", it) }
        return key.sign(claims.build())
    }

    private fun claims(
        platform: Platform,
        now: Instant,
    ) = JWTClaimsSet
        .Builder()
        .issuer(platform.clientId)
        .audience(platform.issuer)
        .claim("azp", platform.issuer)
        .claim("nonce", Secrets.newToken())
        .issueTime(Date.from(now))
        .expirationTime(Date.from(now.plusSeconds(LIFE_SECONDS)))

    private fun item(
        exercise: Exercise,
        wish: LinkWish,
        target: URI,
        language: String,
    ): Map<String, Any> {
        val title = exercise.title(language)
        val line =
            mapOf("scoreMaximum" to exercise.points().total(), "label" to title, "resourceId" to exercise.id())
        return mapOf(
            "type" to LaunchMessage.RESOURCE,
            "title" to title,
            "url" to "$target",
            "custom" to mapOf("exercise" to exercise.id()),
        ) + if (wish.scored) mapOf("lineItem" to line) else emptyMap()
    }

    private companion object {
        const val LIFE_SECONDS = 300L
    }
}
