// How often something may be asked for in a while, and how whoever asks is told.
package rasterlab.grader.limits

import io.ktor.http.HttpHeaders
import io.ktor.server.application.ApplicationCall
import io.ktor.server.plugins.ratelimit.RateLimiter
import io.ktor.server.response.header
import java.time.Duration

/**
 * A limit, and what is left of it.
 *
 * @param limit how often in each [window]
 * @param left how often as yet
 * @param refill the time until more is left; zero where nothing is taken
 */
data class Allowance(
    val limit: Int,
    val left: Int,
    val window: Duration,
    val refill: Duration,
) {
    /** Returns what is left after one more. */
    fun taken() = copy(left = maxOf(left - 1, 0), refill = if (left == limit) window else refill)
}

/** Whole seconds, at least one, after which the time is over. */
fun Duration.secondsToWait(): Int = plusMillis(ALMOST_SECOND_MILLIS).seconds.toInt().coerceAtLeast(1)

/** Tells it with the answer, in the headers of draft-ietf-httpapi-ratelimit-headers-07 (IETF, 2023). */
fun ApplicationCall.tell(allowance: Allowance) {
    response.header("RateLimit-Policy", "${allowance.limit};w=${allowance.window.seconds}")
    response.header("RateLimit-Limit", allowance.limit)
    response.header("RateLimit-Remaining", allowance.left)
    response.header("RateLimit-Reset", if (allowance.refill.isZero) 0 else allowance.refill.secondsToWait())
}

/** Tells what Ktor's limiter says at [now], in milliseconds, and when to try again where nothing is left. */
fun ApplicationCall.tell(
    state: RateLimiter.State,
    limit: Int,
    window: Duration,
    now: Long,
) {
    when (state) {
        is RateLimiter.State.Available -> {
            val refill = Duration.ofMillis(maxOf(state.refillAtTimeMillis - now, 0))
            tell(Allowance(limit, state.remainingTokens, window, refill))
        }

        is RateLimiter.State.Exhausted -> {
            val wait = Duration.ofMillis(state.toWait.inWholeMilliseconds)
            tell(Allowance(limit, 0, window, wait))
            response.header(HttpHeaders.RetryAfter, wait.secondsToWait())
        }
    }
}

private const val ALMOST_SECOND_MILLIS = 999L
