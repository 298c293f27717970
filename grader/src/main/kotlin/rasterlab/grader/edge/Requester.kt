package rasterlab.grader.edge

import io.ktor.http.parseHeaderValue
import rasterlab.grader.problem.LANGUAGES
import rasterlab.grader.problem.isForPrograms
import rasterlab.grader.web.LANGUAGE_COOKIE

/** Who reads the answer to a request: a person in a browser, in one of our languages, or a program. */
internal class Requester(
    val person: Boolean,
    val language: String,
) {
    companion object {
        val UNKNOWN = Requester(person = false, LANGUAGES.first())

        /**
         * The asker as told by what has come of a request's head, which may be cut off or
         * malformed.
         */
        fun of(head: String): Requester {
            val lines = head.split("\r\n", "\n")
            val target = lines.first().split(' ').getOrElse(1) { "" }
            val headers =
                lines.drop(1).takeWhile { it.isNotEmpty() }.associate {
                    it.substringBefore(':').trim().lowercase() to it.substringAfter(':', "").trim()
                }
            val person = "text/html" in headers["accept"].orEmpty() && !isForPrograms(target.substringBefore('?'))
            return Requester(person, language(target, headers))
        }

        private fun language(
            target: String,
            headers: Map<String, String>,
        ): String {
            val asked = target.substringAfter('?', "").split('&').map { it.removePrefix("lang=") }
            val kept = headers["cookie"].orEmpty().split(';').map { it.trim().removePrefix("$LANGUAGE_COOKIE=") }
            val liked = parseHeaderValue(headers["accept-language"]).map { it.value.substringBefore('-').lowercase() }
            return (asked + kept + liked).firstOrNull { it in LANGUAGES } ?: LANGUAGES.first()
        }
    }
}
