package rasterlab.grader.worker

import java.net.InetAddress
import java.net.UnknownHostException

/** Knows the name of this machine, and which names of processes can be used. */
object HostName {
    private const val LONGEST = 63
    private val PLAIN = Regex("[A-Za-z0-9][A-Za-z0-9._-]{0,${LONGEST - 1}}")
    private val ODD = Regex("[^A-Za-z0-9._-]")

    /** The name that the machine gives itself; "worker" where it has none. */
    fun own(): String {
        val name =
            try {
                InetAddress.getLocalHost().hostName
            } catch (nameless: UnknownHostException) {
                // Its message begins with the name that has no address.
                nameless.message.orEmpty().substringBefore(':')
            }
        return name
            .replace(ODD, "-")
            .trimStart('.', '_', '-')
            .take(LONGEST)
            .ifEmpty { "worker" }
    }

    fun isPlain(name: String): Boolean = PLAIN.matches(name)
}
