package rasterlab.grader.web

import io.ktor.http.CookieEncoding
import io.ktor.server.application.ApplicationCall
import rasterlab.exercises.score.GradingVerdict
import rasterlab.grader.exercise.LANGUAGES
import rasterlab.grader.exercise.acceptedLanguage
import rasterlab.grader.wording.Wording
import java.util.Locale

const val LANGUAGE_COOKIE = "lang"

/** The words of the pages in one language. */
class PageTexts private constructor(
    val language: String,
) {
    private val wording = Wording("rasterlab.grader.web.texts", Locale.forLanguageTag(language))

    /** @param values for the places {0}, {1}, … of the text */
    fun say(
        key: String,
        vararg values: Any,
    ): String = wording.say(key, *values)

    fun verdict(code: String): String = GradingVerdict.word(code, language)

    /** The name of a kind of picture; the kind itself where there is none. */
    fun picture(kind: String): String = if (wording.has("picture.$kind")) say("picture.$kind") else kind

    /** The name of a change that was noted; the word of the note where there is none. */
    fun action(word: String): String = if (wording.has("audit.action.$word")) say("audit.action.$word") else word

    /** The unit of the times, as it stands behind "per"; in English where it has no translation. */
    fun item(english: String): String = own("item", english)

    /** The unit of errors; in English where it has no translation. */
    fun unit(english: String): String = own("unit", english)

    /** Keys have hyphens where the engine's words have others. */
    private fun own(
        kind: String,
        english: String,
    ): String {
        val key = "$kind." + english.replace(OTHERS, "-").removePrefix("-")
        return if (wording.has(key)) say(key) else english
    }

    /** Tells what happened and what to do about it. */
    fun problem(code: String): String = say(if (wording.has("problem.$code")) "problem.$code" else "problem.other")

    companion object {
        private val OTHERS = Regex("[^a-z]+")

        fun of(language: String) = PageTexts(language.takeIf { it in LANGUAGES } ?: LANGUAGES.first())
    }
}

/**
 * The texts in the language that `?lang=`, the cookie or the browser asks for, the first that is
 * spoken here.
 */
fun ApplicationCall.texts(): PageTexts {
    val asked = listOfNotNull(request.rawQueryParameters["lang"], request.cookies[LANGUAGE_COOKIE, CookieEncoding.RAW])
    return PageTexts.of((asked.firstOrNull { it in LANGUAGES } ?: acceptedLanguage()).orEmpty())
}
