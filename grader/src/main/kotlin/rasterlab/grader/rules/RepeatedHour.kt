package rasterlab.grader.rules

import rasterlab.grader.wording.Wording
import java.time.Instant
import java.time.ZoneId
import java.time.ZonedDateTime
import java.util.Locale

/** Writes a moment as the clocks of a zone show it, such as 2027-03-28T03:00+02:00. */
internal fun Instant.withOffset(zone: ZoneId): String = "${atZone(zone).toOffsetDateTime()}"

/** Whether the clocks of the zone show that time of day twice, since they are set back after it. */
internal fun ZonedDateTime.comesTwice(): Boolean = zone.rules.getValidOffsets(toLocalDateTime()).size > 1

/** The sentences about moments whose time of day comes twice, in a language. */
internal fun List<RepeatedHour>.said(language: String): List<String> = map { it.said(Locale.forLanguageTag(language)) }

/** A moment of an hour that the clocks of its zone show twice, since they are set back after it. */
class RepeatedHour private constructor(
    private val field: String,
    private val at: ZonedDateTime,
) {
    /** Tells which of the two it is. */
    fun said(language: Locale): String {
        val isLater = at.withLaterOffsetAtOverlap() == at
        return Wording("rasterlab.grader.problem.rules", language).say(
            if (isLater) "twice.later" else "twice.earlier",
            field,
            "${at.toLocalDateTime()}",
            at.zone.named(),
            "${at.toOffsetDateTime()}",
        )
    }

    companion object {
        /** Picks the moments, each with the name of its field, whose time of day comes twice. */
        fun among(
            zone: ZoneId,
            vararg moments: Pair<String, Instant?>,
        ): List<RepeatedHour> =
            moments.mapNotNull { (field, moment) ->
                moment?.atZone(zone)?.takeIf { it.comesTwice() }?.let { RepeatedHour(field, it) }
            }

        /** Picks those of the rules of an exercise. */
        fun among(rules: ExerciseRules): List<RepeatedHour> =
            among(rules.zone, RuleField.OPENS.code to rules.opens, RuleField.DEADLINE.code to rules.due)
    }
}
