package rasterlab.grader.web

import io.ktor.http.CookieEncoding
import io.ktor.server.application.ApplicationCall
import rasterlab.exercises.score.GradingVerdict
import rasterlab.grader.problem.LANGUAGES
import rasterlab.grader.problem.acceptedLanguage
import rasterlab.grader.rules.READERS_ZONE
import rasterlab.grader.rules.comesTwice
import rasterlab.grader.rules.named
import rasterlab.grader.wording.Wording
import java.time.Instant
import java.time.ZoneId
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter
import java.util.Locale

const val LANGUAGE_COOKIE = "lang"

/** The words of the pages in one language, and the times in one zone. */
class PageTexts private constructor(
    val language: String,
    private val readersZone: Lazy<ZoneId>,
) {
    /** The zone of the times on the page. */
    val zone: ZoneId get() = readersZone.value

    val zoneName: String get() = zone.named()

    private val wording = Wording("rasterlab.grader.web.texts", Locale.forLanguageTag(language))

    /** @param values for the places {0}, {1}, … of the text */
    fun say(
        key: String,
        vararg values: Any,
    ): String = wording.say(key, *values)

    /** The moment to the minute with its zone, such as "2027-03-01 23:59 Europe/Moscow". */
    fun time(at: Instant): String = "${minute(at)} $zoneName"

    /** The moment to the minute, where the zone is told beside it; with its offset where that time comes twice. */
    fun minute(at: Instant): String = written(at, MINUTE)

    /** The moment to the second, otherwise as [minute]. */
    fun second(at: Instant): String = written(at, SECOND)

    private fun written(
        at: Instant,
        form: DateTimeFormatter,
    ): String {
        val here = at.atZone(zone)
        return form.format(here) + if (here.comesTwice()) " ${here.offset}" else ""
    }

    fun verdict(code: String): String = GradingVerdict.word(code, language)

    /** The name of a kind of picture; the kind itself where there is none. */
    fun picture(kind: String): String = if (wording.has("picture.$kind")) say("picture.$kind") else kind

    /** The first text that there is; null where there is none. */
    internal fun firstOf(vararg keys: String): String? = keys.firstOrNull(wording::has)?.let { say(it) }

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

        private val MINUTE = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm")

        private val SECOND = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm:ss")

        fun of(
            language: String,
            zone: Lazy<ZoneId> = lazyOf(ZoneOffset.UTC),
        ) = PageTexts(language.takeIf { it in LANGUAGES } ?: LANGUAGES.first(), zone)
    }
}

/**
 * The texts in the language that `?lang=`, the cookie or the browser asks for, the first that is
 * spoken here, and in the zone of the reader's course.
 */
fun ApplicationCall.texts(): PageTexts {
    val asked = listOfNotNull(request.rawQueryParameters["lang"], request.cookies[LANGUAGE_COOKIE, CookieEncoding.RAW])
    val language = (asked.firstOrNull { it in LANGUAGES } ?: acceptedLanguage()).orEmpty()
    return PageTexts.of(language, attributes.getOrNull(READERS_ZONE) ?: lazyOf(ZoneOffset.UTC))
}
