package rasterlab.grader.submission

import rasterlab.grader.problem.Rejection

/** The header lines before a field's content, each kind of them once. */
internal class PartHead {
    var name: String? = null
        private set
    var file: String? = null
        private set

    /** Bytes of the content, or null if nothing is said of them. */
    var length: Int? = null
        private set

    private val met = mutableSetOf<String>()

    /** @param line without its end */
    fun add(line: String) {
        line.firstOrNull { it.isISOControl() && it != '\t' }?.let {
            wrong("has the control character U+%04X".format(it.code))
        }
        if (line.first() in " \t") wrong("is folded")
        if (met.size == MOST_LINES) wrong("is one of more than $MOST_LINES")
        val header = line.substringBefore(':', "").lowercase()
        if (header.isEmpty()) wrong("has no colon or nothing before it")
        if (header.any { it !in TOKEN_SIGNS && it !in 'a'..'z' && it !in '0'..'9' }) wrong("has no header's name")
        if (!met.add(header)) wrong("repeats $header")
        val value = line.substringAfter(':').trim(' ', '\t')
        when (header) {
            "content-disposition" -> {
                disposition(value)
            }

            "content-length" -> {
                length = lengthOf(value)
            }

            "content-transfer-encoding" -> {
                if (value.lowercase() !in PLAIN) wrong("asks for an encoding other than 7bit, 8bit or binary")
            }
        }
    }

    private fun lengthOf(value: String): Int {
        if (value.isEmpty() || value.length > LONGEST_NUMBER || value.any { it !in '0'..'9' }) {
            wrong("has no whole number of bytes")
        }
        return value.toInt()
    }

    private fun disposition(value: String) {
        if (!value.substringBefore(';').trim().equals("form-data", ignoreCase = true)) wrong("is not of a form's field")
        val parameters = Parameters(value).read()
        name = parameters["name"] ?: wrong("has no name")
        file = parameters["filename"]
    }

    /** The parameters behind the first semicolon: `name=token` or `name="text"`, separated by semicolons. */
    private inner class Parameters(
        private val value: String,
    ) {
        private var at = value.indexOf(';').let { if (it < 0) value.length else it }

        fun read(): Map<String, String> {
            val found = mutableMapOf<String, String>()
            while (at < value.length) {
                if (value[at++] != ';') wrong("has something between its parameters")
                skipSpace()
                val start = at
                while (at < value.length && value[at] !in "=; \t") at++
                val parameter = value.substring(start, at).lowercase()
                if (parameter.isEmpty() || at == value.length ||
                    value[at++] != '='
                ) {
                    wrong("has a parameter without value")
                }
                if (found.put(parameter, if (value.startsWith('"', at)) quoted() else token()) != null) {
                    wrong("says its $parameter twice")
                }
                skipSpace()
            }
            return found
        }

        private fun token(): String {
            val start = at
            while (at < value.length && value[at] !in "; \t\"") at++
            if (start == at) wrong("has a parameter without value")
            return value.substring(start, at)
        }

        private fun quoted(): String {
            val text = StringBuilder()
            at++
            while (at < value.length && value[at] != '"') {
                // A path of old browsers has backslashes that escape nothing.
                if (value[at] == '\\' && at + 1 < value.length && value[at + 1] in "\"\\") at++
                text.append(value[at++])
            }
            if (at++ >= value.length) wrong("has a quote that does not end")
            return text.toString()
        }

        private fun skipSpace() {
            while (at < value.length && value[at] in " \t") at++
        }
    }

    private fun wrong(what: String): Nothing = throw Rejection.Malformed("a line of a field's head $what")

    private fun String.startsWith(
        sign: Char,
        place: Int,
    ) = place < length && this[place] == sign

    private companion object {
        const val TOKEN_SIGNS = "!#$%&'*+-.^_`|~"
        const val MOST_LINES = 16
        const val LONGEST_NUMBER = 9
        val PLAIN = setOf("7bit", "8bit", "binary")
    }
}
