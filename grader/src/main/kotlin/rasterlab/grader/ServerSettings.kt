package rasterlab.grader

import rasterlab.grader.institution.InstitutionSettings
import rasterlab.grader.limits.IntakeLimits
import rasterlab.grader.submission.Leases
import java.net.InetAddress
import java.net.URI
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * Tells how a server is to work.
 *
 * @param workers submissions graded at the same time; on two cores one, so that measured speeds mean something
 * @param entriesPerMinute joins and sign-ins from one address; a class behind one router joins at once
 * @param proxies whose word on whom they forward for is believed
 * @param encrypted whether the server's own connections are
 * @param bodyPatience how long the body of a request may take to arrive
 * @param name which no other process has that uses the database
 * @param institution how people sign in by it; null where they do not
 * @param publicAddress of the server as browsers have it; null where each request tells it
 */
data class ServerSettings(
    val workers: Int = 1,
    val intake: IntakeLimits = IntakeLimits(),
    val entriesPerMinute: Int = 120,
    val bodyPatience: Duration = 20.seconds,
    val proxies: Set<InetAddress> = emptySet(),
    val encrypted: Boolean = false,
    val name: String = Leases.ONE_SERVER,
    val institution: InstitutionSettings? = null,
    val publicAddress: URI? = null,
)
