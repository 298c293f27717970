package rasterlab.grader.web

import io.ktor.http.CookieEncoding
import io.ktor.server.application.ApplicationCall
import rasterlab.grader.exercise.LANGUAGES
import rasterlab.grader.exercise.acceptedLanguage
import java.text.MessageFormat
import java.util.Locale
import java.util.ResourceBundle

const val LANGUAGE_COOKIE = "lang"

/** The words of the pages in one language. */
class Texts private constructor(
    val language: String,
) {
    private val locale = Locale.forLanguageTag(language)
    private val bundle =
        ResourceBundle.getBundle(
            "rasterlab.grader.web.texts",
            locale,
            ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_DEFAULT),
        )

    /** @param values for the places {0}, {1}, … of the text */
    fun say(
        key: String,
        vararg values: Any,
    ): String = MessageFormat(bundle.getString(key), locale).format(values)

    fun verdict(code: String): String = say("verdict.$code")

    /** What happened and what to do about it. */
    fun problem(code: String): String =
        say(if (bundle.containsKey("problem.$code")) "problem.$code" else "problem.other")

    companion object {
        fun of(language: String) = Texts(language.takeIf { it in LANGUAGES } ?: LANGUAGES.first())
    }
}

/** In the language that `?lang=`, the cookie or the browser asks for, the first that is spoken here. */
fun ApplicationCall.texts(): Texts {
    val asked = listOfNotNull(request.rawQueryParameters["lang"], request.cookies[LANGUAGE_COOKIE, CookieEncoding.RAW])
    return Texts.of((asked.firstOrNull { it in LANGUAGES } ?: acceptedLanguage()).orEmpty())
}
