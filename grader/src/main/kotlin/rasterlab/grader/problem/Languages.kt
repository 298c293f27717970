package rasterlab.grader.problem

import io.ktor.server.application.ApplicationCall
import io.ktor.server.request.acceptLanguageItems

/** The languages of exercises and pages; the first is for those who speak none of them. */
val LANGUAGES = listOf("en", "ru")

/** The one that `?lang=` names, or else the header. */
fun ApplicationCall.language(): String {
    val asked = request.queryParameters["lang"] ?: return acceptedLanguage() ?: LANGUAGES.first()
    return asked.takeIf { it in LANGUAGES } ?: throw Rejection.UnknownLanguage(asked, LANGUAGES)
}

/**
 * The language of a picture, which its address tells alone: English without one. So the browser may keep it, and a page
 * shows its pictures in its own language.
 */
fun ApplicationCall.pictureLanguage(): String = if ("lang" in request.queryParameters) language() else LANGUAGES.first()

/** The one that `Accept-Language` likes best, or null if it names none of ours. */
fun ApplicationCall.acceptedLanguage(): String? =
    request.acceptLanguageItems().map { it.value.substringBefore('-').lowercase() }.firstOrNull { it in LANGUAGES }
