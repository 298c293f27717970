package rasterlab.grader.submission

import io.ktor.http.ContentType
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.utf8

/** One field of a form; [file] is the name that the browser gives to a file, or null for what was typed. */
internal class FormField(
    val name: String,
    val file: String?,
    val content: ByteArray,
)

/**
 * The fields of a `multipart/form-data` body, in order.
 *
 * Reads what RFC 7578 (2015) and RFC 2046 (1996, section 5.1) allow and nothing else: whoever guesses
 * what a malformed form means may store something that nobody sent. Each byte is looked at once, and
 * once more for each character of the boundary.
 *
 * @throws Rejection.Malformed with the place of what is wrong
 */
internal fun formFields(
    body: ByteArray,
    type: ContentType?,
): List<FormField> = FormReader(body, boundaryOf(type)).fields()

private fun boundaryOf(type: ContentType?): ByteArray {
    val boundary = type?.parameter("boundary") ?: throw Rejection.Malformed("the form has no boundary in Content-Type")
    val fits = boundary.length in 1..LONGEST_BOUNDARY && !boundary.endsWith(' ')
    if (!fits || boundary.any { it !in BOUNDARY_SIGNS && !it.isAsciiLetterOrDigit() }) {
        throw Rejection.Malformed(
            "the form's boundary must have 1 to $LONGEST_BOUNDARY of the characters RFC 2046 allows",
        )
    }
    return boundary.toByteArray()
}

private class FormReader(
    private val body: ByteArray,
    boundary: ByteArray,
) {
    private val delimiter = "\r\n--".toByteArray() + boundary
    private var at = 0

    fun fields(): List<FormField> {
        if (body.isEmpty()) throw Rejection.Malformed("the form is empty: its first boundary is missing")
        val fields = mutableListOf<FormField>()
        at = delimiterFrom(0, first = true) ?: wrong("the form's first boundary is missing")
        while (!atLastBoundary()) {
            if (fields.size == MOST_FIELDS) wrong("the form has more than $MOST_FIELDS fields")
            fields += field()
        }
        return fields
    }

    /** Steps behind the two dashes that end the form, or behind the end of the boundary's line. */
    private fun atLastBoundary(): Boolean {
        if (startsWith(DASHES, at)) return true
        at = lineEnd(at) ?: wrong("the boundary's line does not end")
        return false
    }

    private fun field(): FormField {
        val head = PartHead()
        while (true) {
            val line = line()
            if (line.isEmpty()) break
            val goesOn = at < body.size && (body[at] == SPACE || body[at] == TAB)
            if (goesOn) wrong("a line of a field's head is folded: it goes on in the next line")
            head.add(line)
        }
        val start = at
        // The line end before a boundary belongs to it, also where the content is empty.
        val end = delimiterFrom(start - LINE_END.size) ?: wrong("the form's last boundary is missing")
        val content = body.copyOfRange(start, maxOf(start, end))
        at = end + delimiter.size
        head.length?.let { if (it != content.size) wrong("a field says it has $it bytes and has ${content.size}") }
        return FormField(head.name ?: wrong("a field has no Content-Disposition"), head.file, content)
    }

    /** Bytes up to the next line end, as text; steps behind it. */
    private fun line(): String {
        var end = at
        while (end < body.size && !startsWith(LINE_END, end)) {
            if (end - at == LONGEST_LINE) wrong("a line of a field's head has more than $LONGEST_LINE bytes")
            end++
        }
        if (end == body.size) wrong("a field's head does not end")
        val text = utf8(body.copyOfRange(at, end)) { Rejection.Malformed("a field's head is not UTF-8 text: $it") }
        at = end + LINE_END.size
        return text
    }

    /**
     * Where the next boundary begins whose line holds nothing else.
     *
     * @param first whether it may stand at the beginning of the body, where it has no line end before it
     */
    private fun delimiterFrom(
        from: Int,
        first: Boolean = false,
    ): Int? {
        if (first && startsWith(delimiter, 0, skip = LINE_END.size) && endsLine(delimiter.size - LINE_END.size)) {
            return delimiter.size - LINE_END.size
        }
        var found = from
        while (!(startsWith(delimiter, found) && endsLine(found + delimiter.size))) {
            if (++found + delimiter.size > body.size) return null
        }
        return if (first) found + delimiter.size else found
    }

    private fun endsLine(after: Int) = startsWith(DASHES, after) || lineEnd(after) != null

    /** The place behind the line end, if only spaces and tabs stand before it. */
    private fun lineEnd(from: Int): Int? {
        var end = from
        while (end < body.size && (body[end] == SPACE || body[end] == TAB) && end - from < LONGEST_LINE) end++
        return if (startsWith(LINE_END, end)) end + LINE_END.size else null
    }

    private fun startsWith(
        part: ByteArray,
        place: Int,
        skip: Int = 0,
    ): Boolean {
        if (place < 0 || place + part.size - skip > body.size) return false
        return (skip until part.size).all { body[place + it - skip] == part[it] }
    }

    private fun wrong(what: String): Nothing {
        val place = if (at < body.size) "at byte ${at + 1} of ${body.size}" else "at the end of its ${body.size} bytes"
        throw Rejection.Malformed("$what, $place")
    }

    private companion object {
        val DASHES = "--".toByteArray()
        val LINE_END = "\r\n".toByteArray()
        const val SPACE = ' '.code.toByte()
        const val TAB = '\t'.code.toByte()
        const val LONGEST_LINE = 4096
        const val MOST_FIELDS = 500
    }
}

private const val LONGEST_BOUNDARY = 70
private const val BOUNDARY_SIGNS = "'()+_,-./:=? "

private fun Char.isAsciiLetterOrDigit() = this in 'a'..'z' || this in 'A'..'Z' || this in '0'..'9'
