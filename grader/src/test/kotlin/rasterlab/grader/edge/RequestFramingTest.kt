package rasterlab.grader.edge

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments.argumentSet
import org.junit.jupiter.params.provider.MethodSource
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import kotlin.random.Random

class RequestFramingTest {
    private val framing = RequestFraming()
    private val passed = ByteArrayOutputStream()

    @Test
    fun passesWellMadeRequestsOnAsTheyAre() {
        val seed = Random.nextLong()
        val random = Random(seed)
        val sent = List(300) { WELL_MADE.random(random) }.joinToString("")
        assertNull(feed(sent, random), "seed $seed")
        assertEquals(sent, text(), "seed $seed")
        assertFalse(framing.isWithinRequest)
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("ambiguous")
    fun holdsBackWhatCanBeReadInTwoWays(
        said: String,
        request: String,
    ) {
        val refusal = assertNotNull(feed(WELL_MADE[0] + request + WELL_MADE[0], Random(1)))
        assertTrue(said in framingAnswer(request), framingAnswer(request))
        assertEquals(WELL_MADE[0], text(), "some of it went through, $refusal")
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("brokenBodies")
    fun endsAtABrokenBody(body: String) {
        val head = "POST / HTTP/1.1\r\nHost: x\r\nTransfer-Encoding: chunked\r\n\r\n"
        assertNotNull(feed(head + body + "\r\n\r\nGET /smuggled HTTP/1.1\r\n\r\n", Random(1)))
        assertTrue(framing.isWithinRequest)
        assertFalse("smuggled" in text(), text())
    }

    @Test
    fun passesOverEmptyLinesBeforeARequest() {
        assertNull(feed("\r\n\r\n${WELL_MADE[0]}", Random(1)))
        assertEquals(WELL_MADE[0], text())
    }

    private fun text() = passed.toString(Charsets.ISO_8859_1)

    private fun framingAnswer(request: String): String {
        val refusal =
            RequestFraming().feed(
                ByteBuffer.wrap(request.toByteArray(Charsets.ISO_8859_1)),
                ByteBuffer.allocate(1 shl 16),
            )
        return checkNotNull(refusal).answer(Requester.UNKNOWN).decodeToString()
    }

    /** Feeds a text in pieces of any length. */
    private fun feed(
        text: String,
        random: Random,
    ): Refusal? {
        val bytes = text.toByteArray(Charsets.ISO_8859_1)
        var at = 0
        while (at < bytes.size) {
            val count = random.nextInt(1, minOf(200, bytes.size - at) + 1)
            val output = ByteBuffer.allocate(RequestFraming.MOST_HEAD + count)
            val refusal = framing.feed(ByteBuffer.wrap(bytes, at, count), output)
            passed.write(output.array(), 0, output.position())
            if (refusal != null) return refusal
            at += count
        }
        return null
    }

    companion object {
        private val WELL_MADE =
            listOf(
                "GET /a HTTP/1.1\r\nHost: x\r\n\r\n",
                "POST /b HTTP/1.1\r\nHost: x\r\nContent-Length: 5\r\n\r\nab\r\n\r",
                "POST /c HTTP/1.1\r\nHost:\r\ncontent-length:0\r\n\r\n",
                "PUT /d HTTP/1.1\r\nHost: [::1]:8080\r\nTransfer-Encoding: Chunked\r\n\r\n3;x=y\r\na\r\n\r\n0\r\nX: y\r\n\r\n",
                "POST /e HTTP/1.1\r\nhost: x:1\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
                "DELETE /f HTTP/1.0\r\nX: \u00e9\r\n\r\n",
            )

        private fun post(vararg headers: String) =
            (listOf("POST / HTTP/1.1") + headers).joinToString("\r\n", postfix = "\r\n\r\n")

        @JvmStatic
        fun ambiguous() =
            listOf(
                argumentSet("no host", "one Host", post("X: y")),
                argumentSet("two hosts", "one Host", post("Host: x", "host: x")),
                argumentSet("a host with a path", "one Host", post("Host: x/y")),
                argumentSet("two hosts in HTTP/1.0", "one Host", "GET / HTTP/1.0\r\nHost: x\r\nHost: y\r\n\r\n"),
                argumentSet("two kinds of length", "together", post("Content-Length: 5", "Transfer-Encoding: chunked")),
                argumentSet("the other way round", "together", post("transfer-encoding: chunked", "content-length: 5")),
                argumentSet(
                    "an unknown encoding and a length",
                    "together",
                    post("Transfer-Encoding: x", "Content-Length: 5"),
                ),
                argumentSet("an unknown encoding", "may only be", post("Transfer-Encoding: gzip, chunked")),
                argumentSet(
                    "an encoding twice",
                    "may only be",
                    post("Transfer-Encoding: chunked", "Transfer-Encoding: chunked"),
                ),
                argumentSet(
                    "an encoding in HTTP/1.0",
                    "may only be",
                    "POST / HTTP/1.0\r\nTransfer-Encoding: chunked\r\n\r\n",
                ),
                argumentSet("a length of -1", "whole number", post("Content-Length: -1")),
                argumentSet("a length of +5", "whole number", post("Content-Length: +5")),
                argumentSet("a length of x", "whole number", post("Content-Length: x")),
                argumentSet("an empty length", "whole number", post("Content-Length:")),
                argumentSet("two lengths", "whole number", post("Content-Length: 5", "Content-Length: 5")),
                argumentSet("a list of lengths", "whole number", post("Content-Length: 5, 5")),
                argumentSet("a space before the colon", "in its name", post("Content-Length : 5")),
                argumentSet("a folded header", "folded", post("X: a", " Content-Length: 5")),
                argumentSet("a header without a colon", "no colon", post("Content-Length")),
                argumentSet("a newline alone", "CR LF", "GET / HTTP/1.1\nHost: x\r\n\r\n"),
                argumentSet("a return alone", "CR LF", "GET / HTTP/1.1\rHost: x\r\n\r\n"),
                argumentSet("a NUL", "NUL", post("X: a\u0000b")),
                argumentSet("a head of 17 KiB", "at most 16384", post("X: " + "a".repeat(17 * 1024))),
            )

        @JvmStatic
        fun brokenBodies() =
            listOf(
                argumentSet("a chunk of no length", "x\r\nabc"),
                argumentSet("a chunk of a signed length", "+3\r\nabc"),
                argumentSet("a chunk that goes on", "3\r\nabcd"),
                argumentSet("a chunk of endless length", "fffffffff\r\nabc"),
                argumentSet("a chunk without a line's end", "3\nabc"),
            )
    }
}
