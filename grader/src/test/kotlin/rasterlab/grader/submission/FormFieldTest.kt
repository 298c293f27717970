package rasterlab.grader.submission

import io.ktor.http.ContentType
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments.argumentSet
import org.junit.jupiter.params.provider.MethodSource
import rasterlab.grader.problem.Rejection
import kotlin.random.Random

/** A form is read as it was sent, or refused with the place of what is wrong; never guessed, never a failure. */
class FormFieldTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("wellMade")
    fun reads(
        body: String,
        expected: List<String>,
    ) {
        assertEquals(expected, formFields(body.toByteArray(), TYPE).map { "${it.name}=${it.content.decodeToString()}" })
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("malformed")
    fun refuses(
        said: String,
        body: String,
    ) {
        val refusal =
            assertThrows(Rejection.Malformed::class.java) { formFields(body.toByteArray(Charsets.UTF_8), TYPE) }
        assertTrue(said in refusal.message, "'${refusal.message}' instead of '$said'")
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("types")
    fun refusesABoundary(type: ContentType) {
        val refusal =
            assertThrows(Rejection.Malformed::class.java) { formFields(field("class A {}").toByteArray(), type) }
        assertTrue("boundary" in refusal.message, refusal.message)
    }

    @Test
    fun readsAnyContentBack() {
        val seed = Random.nextLong()
        val random = Random(seed)
        repeat(ROUNDS) {
            val contents = List(random.nextInt(4)) { noise(random, random.nextInt(60)) }
            val body =
                contents.fold(
                    ByteArray(0),
                ) { all, one -> all + "--b\r\n$NAMED\r\n\r\n".toByteArray() + one + END }
            val read = formFields((body + "--b--\r\n".toByteArray()).drop(0).toByteArray(), TYPE)
            assertEquals(contents.size, read.size, "seed $seed")
            contents.zip(read).forEach { (sent, found) -> assertArrayEquals(sent, found.content, "seed $seed") }
        }
    }

    @Test
    fun failsOnNoForm() {
        val seed = Random.nextLong()
        val random = Random(seed)
        var refused = 0
        repeat(ROUNDS) {
            val body = mutated(random)
            try {
                formFields(body, TYPE)
            } catch (refusal: Rejection.Malformed) {
                refused++
            } catch (failure: Exception) {
                throw AssertionError("seed $seed: ${body.decodeToString()}", failure)
            }
        }
        assertTrue(refused in ROUNDS / 10..<ROUNDS, "$refused of $ROUNDS were refused, seed $seed")
    }

    /** Bytes that look like a form's, without a boundary. */
    private fun noise(
        random: Random,
        length: Int,
    ): ByteArray =
        ByteArray(length) {
            SIGNS[random.nextInt(SIGNS.length)].code.toByte()
        }.let { if (holdsBoundary(it)) noise(random, length) else it }

    private fun holdsBoundary(content: ByteArray) = "\r\n--b" in "\r\n${content.decodeToString()}\r\n"

    /** A well-made form in which some bytes are changed, left out, doubled or moved. */
    private fun mutated(random: Random): ByteArray {
        val body =
            (
                field(
                    "class A {}",
                    "Content-Length: 10",
                ) + "--b\r\n$NAMED\r\n\r\nx\r\n--b--\r\n"
            ).toByteArray().toMutableList()
        repeat(random.nextInt(1, 6)) {
            if (body.isEmpty()) return@repeat
            val at = random.nextInt(body.size)
            when (random.nextInt(5)) {
                0 -> body[at] = random.nextInt(256).toByte()
                1 -> body[at] = SIGNS[random.nextInt(SIGNS.length)].code.toByte()
                2 -> body.removeAt(at)
                3 -> body.addAll(at, body.subList(at, minOf(at + random.nextInt(20), body.size)).toList())
                else -> while (body.size > maxOf(at, 1)) body.removeLast()
            }
        }
        return body.toByteArray()
    }

    companion object {
        private const val ROUNDS = 20_000
        private const val SIGNS = "\r\n--b: ;=\"a\u0000\t\\"
        private const val NAMED = "Content-Disposition: form-data; name=\"source\""
        private val END = "\r\n".toByteArray()
        private val TYPE = ContentType.parse("multipart/form-data; boundary=b")

        private fun field(
            content: String,
            vararg head: String,
        ) = (listOf("--b", NAMED) + head + listOf("", content, "")).joinToString("\r\n")

        private fun form(
            head: String,
            content: String = "class A {}",
        ) = "--b\r\n$head\r\n\r\n$content\r\n--b--\r\n"

        @JvmStatic
        fun wellMade() =
            listOf(
                argumentSet("one field", form(NAMED), listOf("source=class A {}")),
                argumentSet("no line end after the last boundary", form(NAMED).trim(), listOf("source=class A {}")),
                argumentSet("no field at all", "--b--", emptyList<String>()),
                argumentSet("empty content", form(NAMED, ""), listOf("source=")),
                argumentSet("content left out", "--b\r\n$NAMED\r\n\r\n--b--", listOf("source=")),
                argumentSet("text before and after", "by a mailer\r\n${form(NAMED)}bye", listOf("source=class A {}")),
                argumentSet(
                    "spaces after a boundary",
                    form(NAMED).replaceFirst("--b", "--b \t"),
                    listOf("source=class A {}"),
                ),
                argumentSet("a longer boundary inside", form(NAMED, "x\r\n--bc\r\n"), listOf("source=x\r\n--bc\r\n")),
                argumentSet("line ends of three kinds", form(NAMED, "a\rb\nc\r\n"), listOf("source=a\rb\nc\r\n")),
                argumentSet(
                    "a file whose name has quotes and letters",
                    form("$NAMED; filename=\"Моё \\\"x\\\".java\"\r\nContent-Type: text/plain"),
                    listOf("source=class A {}"),
                ),
                argumentSet(
                    "a name without quotes",
                    form("content-disposition: form-data;name=source"),
                    listOf("source=class A {}"),
                ),
                argumentSet("the right length", form("$NAMED\r\nContent-Length: 10"), listOf("source=class A {}")),
                argumentSet("two fields", field("a") + form(NAMED, "b"), listOf("source=a", "source=b")),
            )

        @JvmStatic
        fun malformed() = boundaries() + headers() + lengths() + dispositions()

        private fun boundaries() =
            listOf(
                argumentSet("an empty body", "first boundary is missing", ""),
                argumentSet("another boundary inside", "first boundary is missing", form(NAMED).replace("--b", "--c")),
                argumentSet(
                    "no closing boundary",
                    "last boundary is missing",
                    form(NAMED).removeSuffix("\r\n--b--\r\n"),
                ),
                argumentSet(
                    "a closing boundary of one dash",
                    "last boundary is missing",
                    form(NAMED).removeSuffix("-\r\n"),
                ),
                argumentSet("only the first boundary", "head does not end", "--b\r\n"),
                argumentSet("a boundary's line that does not end", "first boundary is missing", "--b"),
                argumentSet("a head that does not end", "head does not end", "--b\r\n$NAMED"),
            )

        private fun headers() =
            listOf(
                argumentSet("a header without a colon", "has no colon", form("$NAMED\r\nrubbish")),
                argumentSet("a header without a name", "has no colon", form("$NAMED\r\n: x")),
                argumentSet(
                    "a space before the colon",
                    "no header's name",
                    form("Content-Disposition : form-data; name=source"),
                ),
                argumentSet(
                    "a parameter in the next line",
                    "is folded",
                    form("Content-Disposition: form-data;\r\n name=source"),
                ),
                argumentSet("a form without bytes", "the form is empty", ""),
                argumentSet(
                    "a folded header",
                    "is folded",
                    form("$NAMED\r\nX-Note: a\r\n b"),
                ),
                argumentSet("a NUL in a header", "U+0000", form("$NAMED\r\nContent-Type: text/\u0000plain")),
                argumentSet("a bell in a header's name", "U+0007", form("$NAMED\r\nContent\u0007-Type: text/plain")),
                argumentSet(
                    "an escape in a field's name",
                    "U+001B",
                    form("Content-Disposition: form-data; name=\"sou\u001Brce\""),
                ),
                argumentSet(
                    "a line end in a field's name",
                    "U+000A",
                    form("Content-Disposition: form-data; name=\"sou\nrce\""),
                ),
                argumentSet("a carriage return in a file's name", "U+000D", form("$NAMED; filename=\"a\rb\"")),
            )

        private fun lengths() =
            listOf(
                argumentSet("a length of -1", "no whole number", form("$NAMED\r\nContent-Length: -1")),
                argumentSet("a length of x", "no whole number", form("$NAMED\r\nContent-Length: x")),
                argumentSet("a length of nothing", "no whole number", form("$NAMED\r\nContent-Length:")),
                argumentSet(
                    "a length beyond all",
                    "no whole number",
                    form("$NAMED\r\nContent-Length: 99999999999999999999"),
                ),
                argumentSet(
                    "a length that is too small",
                    "says it has 9 bytes and has 10",
                    form("$NAMED\r\nContent-Length: 9"),
                ),
                argumentSet("a length that is too large", "says it has 99 bytes", form("$NAMED\r\nContent-Length: 99")),
                argumentSet(
                    "two lengths",
                    "repeats content-length",
                    form("$NAMED\r\nContent-Length: 10\r\nContent-Length: 10"),
                ),
            )

        private fun dispositions() =
            listOf(
                argumentSet("two dispositions", "repeats content-disposition", form("$NAMED\r\n$NAMED")),
                argumentSet("no disposition", "no Content-Disposition", form("Content-Type: text/plain")),
                argumentSet("no head", "no Content-Disposition", "--b\r\n\r\nclass A {}\r\n--b--"),
                argumentSet("a disposition without a name", "has no name", form("Content-Disposition: form-data")),
                argumentSet(
                    "another disposition",
                    "not of a form's field",
                    form("Content-Disposition: attachment; name=\"source\""),
                ),
                argumentSet("an open quote", "does not end", form("Content-Disposition: form-data; name=\"source")),
                argumentSet("two names", "name twice", form("$NAMED; name=\"other\"")),
                argumentSet("a parameter without a value", "without value", form("$NAMED; filename")),
                argumentSet("text between parameters", "between its parameters", form("$NAMED x; filename=\"a\"")),
                argumentSet(
                    "content in base64",
                    "asks for an encoding",
                    form("$NAMED\r\nContent-Transfer-Encoding: base64"),
                ),
                argumentSet(
                    "a head of 5,000 bytes in one line",
                    "more than 4096",
                    form("$NAMED\r\nX: ${"x".repeat(5_000)}"),
                ),
                argumentSet(
                    "17 lines of head",
                    "more than 16",
                    form(NAMED + (1..16).joinToString("") { "\r\nX-$it: x" }),
                ),
                argumentSet("501 fields", "more than 500 fields", field("x").repeat(501) + "--b--"),
            )

        @JvmStatic
        fun types() =
            listOf(
                argumentSet("none", ContentType.parse("multipart/form-data")),
                argumentSet("empty", ContentType.parse("multipart/form-data; boundary=\"\"")),
                argumentSet("71 characters", ContentType.parse("multipart/form-data; boundary=${"b".repeat(71)}")),
                argumentSet("a line end", ContentType.parse("multipart/form-data; boundary=\"b\r\nc\"")),
                argumentSet("a letter beyond ASCII", ContentType.parse("multipart/form-data; boundary=\"é\"")),
                argumentSet("a space at its end", ContentType.parse("multipart/form-data; boundary=\"b \"")),
            )
    }
}
