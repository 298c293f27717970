package rasterlab.grader.exam

import java.net.InetAddress

/**
 * The networks from which an exam can be opened, such as `192.0.2.0/24` or `2001:db8::/32`; an address alone is a
 * network of one. No network means any address.
 *
 * @property text the networks as they were written, with spaces between them
 */
class AddressList private constructor(
    val text: String,
    private val networks: List<Network>,
) {
    /** Whether an address in digits is in one of the networks. */
    fun allows(address: String): Boolean {
        if (networks.isEmpty()) return true
        val bytes = digits(address.substringBefore('%')) ?: return false
        return networks.any { it.holds(bytes) }
    }

    override fun equals(other: Any?) = other is AddressList && other.text == text

    override fun hashCode() = text.hashCode()

    override fun toString() = text

    private class Network(
        private val first: ByteArray,
        private val bits: Int,
    ) {
        fun holds(address: ByteArray): Boolean =
            address.size == first.size && (0 until bits).all { bit(address, it) == bit(first, it) }

        private fun bit(
            of: ByteArray,
            number: Int,
        ) = of[number / 8].toInt() shr (7 - number % 8) and 1
    }

    companion object {
        private val IPV4 = Regex("""\d{1,3}(\.\d{1,3}){3}""")
        private val IPV6 = Regex("""[0-9a-fA-F:.]*:[0-9a-fA-F:.]*""")
        private val BETWEEN = Regex("[\\s,;]+")

        /**
         * Reads networks with spaces or commas between them.
         *
         * @param refused makes what is thrown of one that is none
         */
        fun of(
            text: String,
            refused: (String) -> Exception = { IllegalArgumentException("no network: $it") },
        ): AddressList {
            val told = text.trim().split(BETWEEN).filter { it.isNotEmpty() }
            return AddressList(told.joinToString(" "), told.map { network(it) ?: throw refused(it) })
        }

        private fun network(text: String): Network? {
            val bytes = digits(text.substringBefore('/')) ?: return null
            val all = bytes.size * 8
            val bits = if ('/' in text) text.substringAfter('/').toIntOrNull() else all
            return bits?.takeIf { it in 0..all }?.let { Network(bytes, it) }
        }

        /** The bytes of an address in digits; a name is none, so that nothing is looked up. */
        private fun digits(address: String): ByteArray? {
            val numeric =
                if (IPV4.matches(address)) address.split('.').all { it.toInt() <= 255 } else IPV6.matches(address)
            return if (numeric) runCatching { InetAddress.getByName(address).address }.getOrNull() else null
        }
    }
}
