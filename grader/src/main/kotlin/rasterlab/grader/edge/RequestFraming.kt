package rasterlab.grader.edge

import io.ktor.http.HttpStatusCode
import java.nio.ByteBuffer

/**
 * Follows where each request of a connection begins and ends, as RFC 9112 (2022) lays it out, and lets
 * through only what cannot be read in two ways: the head of a request is held back until it is whole.
 */
internal class RequestFraming {
    private enum class State { HEAD, BODY, CHUNK_SIZE, CHUNK, CHUNK_END, TRAILER, REST }

    private var state = State.HEAD
    private val held by lazy { ByteArray(MOST_HEAD) }
    private var length = 0

    /** Whether some of a request went through, and not yet all of it. */
    val isWithinRequest get() = state != State.HEAD

    /** Who reads the answer to the request that is on its way, or to the last one. */
    var asker = Requester.UNKNOWN
        private set

    /** Bytes of the body or chunk that are still to come. */
    private var left = 0L

    /** Moves bytes from [input] to [output], or says why the connection must end; then the rest is not for anybody. */
    fun feed(
        input: ByteBuffer,
        output: ByteBuffer,
    ): Refusal? {
        while (input.hasRemaining()) {
            val refusal =
                when (state) {
                    State.HEAD -> holdHead(input, output)
                    State.REST -> null.also { output.put(input) }
                    State.BODY, State.CHUNK -> null.also { pass(input, output) }
                    State.CHUNK_SIZE, State.CHUNK_END, State.TRAILER -> holdLine(input, output)
                }
            if (refusal != null) {
                if (state == State.HEAD) asker = Requester.of(text() + Charsets.ISO_8859_1.decode(input))
                return refusal
            }
        }
        return null
    }

    /** Names the fault where the client sends no more. */
    fun atEnd(): Refusal? = if (state == State.HEAD || state == State.REST) null else CUT_OFF

    private fun pass(
        input: ByteBuffer,
        output: ByteBuffer,
    ) {
        val count = minOf(left, input.remaining().toLong()).toInt()
        output.put(input.slice().limit(count))
        input.position(input.position() + count)
        left -= count
        if (left == 0L) state = if (state == State.BODY) State.HEAD else State.CHUNK_END
    }

    private fun holdHead(
        input: ByteBuffer,
        output: ByteBuffer,
    ): Refusal? {
        while (input.hasRemaining()) {
            hold(input.get())?.let { return it }
            if (length == EMPTY_LINE && endsWith("\r\n")) {
                // Before a request it is passed over.
                length = 0
            } else if (endsWith("\r\n\r\n")) {
                begin(text().removeSuffix("\r\n\r\n"))?.let { return it }
                return null.also { release(output) }
            }
        }
        return null
    }

    private fun holdLine(
        input: ByteBuffer,
        output: ByteBuffer,
    ): Refusal? {
        while (input.hasRemaining()) {
            hold(input.get())?.let { return it }
            if (endsWith("\r\n")) {
                endLine(text().removeSuffix("\r\n"))?.let { return it }
                return null.also { release(output) }
            }
        }
        return null
    }

    private fun hold(byte: Byte): Refusal? {
        if (length == MOST_HEAD) return TOO_LONG
        val afterReturn = length > 0 && held[length - 1] == RETURN
        if (byte == ZERO || (byte == NEWLINE) != afterReturn) return BAD_LINE
        held[length++] = byte
        return null
    }

    private fun endsWith(end: String) =
        length >= end.length && end.indices.all { held[length - end.length + it] == end[it].code.toByte() }

    private fun text() = String(held, 0, length, Charsets.ISO_8859_1)

    private fun release(output: ByteBuffer) {
        output.put(held, 0, length)
        length = 0
    }

    private fun endLine(line: String): Refusal? {
        when (state) {
            State.CHUNK_SIZE -> {
                val size = line.substringBefore(';').trimEnd(' ', '\t')
                if (size.isEmpty() || size.length > CHUNK_DIGITS || size.any { it !in HEXADECIMAL }) return BAD_CHUNK
                left = size.toLong(radix = 16)
                state = if (left == 0L) State.TRAILER else State.CHUNK
            }

            State.CHUNK_END -> {
                if (line.isEmpty()) state = State.CHUNK_SIZE else return BAD_CHUNK
            }

            else -> {
                if (line.isEmpty()) state = State.HEAD
            }
        }
        return null
    }

    private fun begin(head: String): Refusal? {
        val lines = head.split("\r\n")
        val headers = mutableMapOf<String, MutableList<String>>()
        for (line in lines.drop(1)) {
            val name = line.substringBefore(':', "")
            if (name.isEmpty() || name.any { it <= ' ' || it == DELETE }) return BAD_HEADER
            headers.getOrPut(name.lowercase(), ::mutableListOf) += line.substringAfter(':').trim(' ', '\t')
        }
        asker = Requester.of(head)
        val version = lines.first().substringAfterLast(' ')
        val lengths = headers["content-length"].orEmpty()
        val encodings = headers["transfer-encoding"].orEmpty()
        val fault = faultOfLength(version, lengths, encodings) ?: faultOfHost(version, headers["host"].orEmpty())
        if (fault != null) return fault
        left = lengths.firstOrNull()?.toLong() ?: 0
        state =
            when {
                encodings.isNotEmpty() -> State.CHUNK_SIZE
                left > 0 -> State.BODY
                else -> afterNoBody(lines.first(), headers, lengths.isEmpty())
            }
        return null
    }

    private fun faultOfLength(
        version: String,
        lengths: List<String>,
        encodings: List<String>,
    ): Refusal? {
        val chunked = encodings.singleOrNull().equals("chunked", ignoreCase = true)
        val number = lengths.all { it.length in 1..LENGTH_DIGITS && it.all { digit -> digit in '0'..'9' } }
        return when {
            lengths.isNotEmpty() && encodings.isNotEmpty() -> TWO_LENGTHS
            encodings.isNotEmpty() && (!chunked || version != HTTP_1_1) -> BAD_ENCODING
            lengths.size > 1 || !number -> BAD_LENGTH
            else -> null
        }
    }

    /** Section 3.2 asks for one, and for this answer. */
    private fun faultOfHost(
        version: String,
        hosts: List<String>,
    ): Refusal? {
        val least = if (version == HTTP_1_1) 1 else 0
        val plain = hosts.all { host -> host.none { it <= ' ' || it in "/?#@,\\" || it == DELETE } }
        return if (hosts.size in least..1 && plain) null else BAD_HOST
    }

    /** The engine takes all that comes for the body where nothing tells a length and the connection is to end. */
    private fun afterNoBody(
        requestLine: String,
        headers: Map<String, List<String>>,
        untold: Boolean,
    ): State {
        val ends = headers["connection"].orEmpty().any { it.contains("close", ignoreCase = true) }
        val bodiless = requestLine.substringBefore(' ') in setOf("GET", "HEAD", "OPTIONS")
        return if (untold && ends && !bodiless) State.REST else State.HEAD
    }

    companion object {
        const val MOST_HEAD = 16 * 1024
        private const val HTTP_1_1 = "HTTP/1.1"
        private const val EMPTY_LINE = 2
        private const val CHUNK_DIGITS = 8
        private const val LENGTH_DIGITS = 18
        private const val DELETE = '\u007f'
        private const val HEXADECIMAL = "0123456789abcdefABCDEF"
        private const val RETURN = '\r'.code.toByte()
        private const val NEWLINE = '\n'.code.toByte()
        private const val ZERO: Byte = 0
        private val TOO_LONG =
            Refusal(
                HttpStatusCode(431, "Request Header Fields Too Large"),
                "head-too-large",
                "the request's line and headers may have at most $MOST_HEAD bytes",
            )
        private val BAD_LINE = malformed("a line of the request ends without CR LF, or holds a NUL")
        private val BAD_HEADER =
            malformed("a header is folded, has no colon, or a space or control character in its name")
        private val BAD_CHUNK =
            malformed("a chunk of the body does not begin with its length, or does not end after it")
        private val CUT_OFF = malformed("the body ends before its length")
        private val TWO_LENGTHS = malformed("Content-Length stands together with Transfer-Encoding")
        private val BAD_ENCODING = malformed("Transfer-Encoding may only be 'chunked', once, in HTTP/1.1")
        private val BAD_HOST =
            malformed("a request of HTTP/1.1 must have one Host header, with a host and perhaps a port")
        private val BAD_LENGTH = malformed("Content-Length must be one whole number of bytes")
    }
}
