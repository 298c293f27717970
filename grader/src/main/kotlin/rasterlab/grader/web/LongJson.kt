package rasterlab.grader.web

import kotlinx.html.FlowContent
import kotlinx.html.FlowOrPhrasingContent
import kotlinx.html.code
import kotlinx.html.details
import kotlinx.html.p
import kotlinx.html.pre
import kotlinx.html.summary

/** The most characters of JSON that stand within a sentence. */
private const val IN_SENTENCE = 120

/** The length to which longer JSON is cut there. */
private const val BEGINNING = 40

/**
 * A part of a message.
 *
 * @param json whether it is a whole object in JSON
 */
data class MessagePart(
    val text: String,
    val json: Boolean,
) {
    val isFolded get() = json && text.length > IN_SENTENCE
}

/** A message in which long JSON is shortened, to be opened below it. */
fun FlowContent.message(
    texts: PageTexts,
    message: String,
) {
    p { sentence(message) }
    folded(texts, message)
}

/** The message with long JSON shortened. */
fun FlowOrPhrasingContent.sentence(message: String) =
    partsOf(message).forEach { part ->
        if (part.json) code { +shown(part) } else +part.text
    }

/** The part that [sentence] leaves out. */
fun FlowContent.folded(
    texts: PageTexts,
    message: String,
) {
    partsOf(message).filter { it.isFolded }.forEach { part ->
        details {
            summary { +texts.say("result.json", part.text.length) }
            pre("json") { code { +part.text } }
        }
    }
}

private fun shown(part: MessagePart) = if (part.isFolded) part.text.take(BEGINNING) + "…" else part.text

/** The message cut where an object in JSON begins and ends; one that never ends is no such object. */
fun partsOf(message: String): List<MessagePart> {
    val parts = mutableListOf<MessagePart>()
    var done = 0
    while (true) {
        val start = message.indexOf("{\"", done)
        val end = if (start < 0) null else endOfObject(message, start)
        if (end == null) break
        if (start > done) parts += MessagePart(message.substring(done, start), false)
        parts += MessagePart(message.substring(start, end), true)
        done = end
    }
    if (done < message.length) parts += MessagePart(message.substring(done), false)
    return parts
}

/** The place behind the brace that closes the one at [start]; null where none does. */
private fun endOfObject(
    text: String,
    start: Int,
): Int? {
    var depth = 0
    var quoted = false
    var at = start
    while (at < text.length) {
        when (text[at]) {
            '\\' -> if (quoted) at++
            '"' -> quoted = !quoted
            '{' -> if (!quoted) depth++
            '}' -> if (!quoted && --depth == 0) return at + 1
        }
        at++
    }
    return null
}
