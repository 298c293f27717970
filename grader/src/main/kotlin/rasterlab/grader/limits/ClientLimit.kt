package rasterlab.grader.limits

import io.ktor.server.application.ApplicationCall
import io.ktor.server.plugins.ratelimit.RateLimitConfig
import io.ktor.server.plugins.ratelimit.RateLimitName
import java.time.Duration
import java.time.InstantSource
import kotlin.time.Duration.Companion.minutes

/**
 * Limits how often in a minute one client may come to the routes of [name].
 *
 * @param client names the client of a call
 */
internal fun RateLimitConfig.limit(
    name: RateLimitName,
    perMinute: Int,
    clock: InstantSource,
    client: (ApplicationCall) -> Any,
) = register(name) {
    rateLimiter(perMinute, 1.minutes, clock = clock::millis)
    requestKey { client(it) }
    modifyResponse { call, state -> call.tell(state, perMinute, Duration.ofMinutes(1), clock.millis()) }
}
