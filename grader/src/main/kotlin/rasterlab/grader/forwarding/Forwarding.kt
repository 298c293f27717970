// Who a call comes from where reverse proxies stand in front of the server.
package rasterlab.grader.forwarding

import io.ktor.server.application.ApplicationCall
import io.ktor.util.AttributeKey
import java.net.InetAddress

/**
 * Tells whom a call comes from where reverse proxies stand in front of the server. Their headers `X-Forwarded-For` and
 * `X-Forwarded-Proto` are believed when the connection comes from one of [proxies]; anybody else could write them too.
 *
 * @param direct the address at the other end of the connection
 * @param encrypted whether the server itself encrypts its connections
 */
class Forwarding(
    private val proxies: Set<InetAddress>,
    private val direct: (ApplicationCall) -> String,
    private val encrypted: Boolean = false,
) {
    /** The address nearest to the server that is no proxy of ours; what stands before it is the client's own word. */
    fun clientOf(call: ApplicationCall): String {
        val connected = direct(call)
        if (!isProxy(connected)) return connected
        val forwarded =
            call.request.headers
                .getAll("X-Forwarded-For")
                .orEmpty()
                .flatMap { it.split(',') }
        return forwarded.map { it.trim() }.lastOrNull { !isProxy(it) }?.takeIf { parse(it) != null } ?: connected
    }

    /** Whether the client's own connection is encrypted. */
    fun isSecure(call: ApplicationCall): Boolean =
        encrypted ||
            (isProxy(direct(call)) && call.request.headers["X-Forwarded-Proto"].equals("https", ignoreCase = true))

    /** Puts all of it with the call, for whoever answers it. */
    fun note(call: ApplicationCall) {
        call.attributes.put(SECURE, isSecure(call))
        call.attributes.put(CLIENT, clientOf(call))
        call.attributes.put(FROM_PROXY, isProxy(direct(call)))
    }

    private fun isProxy(address: String) = parse(address) in proxies

    companion object {
        /** Whether the client's connection is encrypted, with each call. */
        val SECURE = AttributeKey<Boolean>("rasterlab secure")

        /** The client's own address, with each call. */
        val CLIENT = AttributeKey<String>("rasterlab client")

        /** Whether the connection is one of a proxy, with each call. */
        val FROM_PROXY = AttributeKey<Boolean>("rasterlab from a proxy")

        private const val BYTE = "(25[0-5]|2[0-4][0-9]|1?[0-9]?[0-9])"
        private val IPV4 = Regex("""$BYTE(\.$BYTE){3}""")

        /** Addresses with commas between them; null where one of them is none. */
        fun proxies(text: String): Set<InetAddress>? {
            val all = text.split(',').map { parse(it.trim()) }
            return if (all.any { it == null }) null else all.filterNotNull().toSet()
        }

        /** An address in digits; a name is none, so that nothing is looked up. */
        private fun parse(address: String): InetAddress? {
            if (':' !in address && !IPV4.matches(address)) return null
            return runCatching { InetAddress.getByName(address) }.getOrNull()
        }
    }
}
