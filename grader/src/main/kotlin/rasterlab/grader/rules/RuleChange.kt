package rasterlab.grader.rules

import rasterlab.grader.problem.Rejection
import java.time.DateTimeException
import java.time.Instant
import java.time.LocalDateTime
import java.time.OffsetDateTime
import java.time.ZoneId

/** The names of what can be ruled, as in the HTTP API. */
enum class RuleField(
    val code: String,
) {
    OPENS("opens"),
    DEADLINE("deadline"),
    ZONE("zone"),
    LATE_DAYS("lateDays"),
    ATTEMPTS("attempts"),
    POLICY("policy"),
    LATE_PENALTY("latePenalty"),
}

/**
 * Tells what is to become of the rules of an exercise.
 *
 * @param told texts as somebody wrote them, empty for none; what is not told stays as it is
 */
class RuleChange(
    private val told: Map<RuleField, String>,
) {
    /** @throws Rejection.BadRule that names the field, what it is, and what is allowed */
    fun of(before: ExerciseRules): ExerciseRules {
        val zone = told[RuleField.ZONE]?.let(::zone) ?: before.zone
        val after =
            ExerciseRules(
                opens = changed(RuleField.OPENS, before.opens) { moment(code, it, zone, before.opens, begins = true) },
                due = changed(RuleField.DEADLINE, before.due) { moment(code, it, zone, before.due) },
                zone,
                lateDays = changed(RuleField.LATE_DAYS, before.lateDays) { number(this, it, 0..MOST_DAYS) },
                attempts = changed(RuleField.ATTEMPTS, before.attempts) { number(this, it, 1..MOST_ATTEMPTS) },
                policy = told[RuleField.POLICY]?.let(::policy) ?: before.policy,
                latePenalty =
                    changed(RuleField.LATE_PENALTY, before.latePenalty) {
                        number(this, it, ExerciseRules.PERCENT, "penalty")
                    }
                        ?: 0,
            )
        if (after.opens != null && after.due != null && after.opens >= after.due) {
            throw Rejection.BadRule("order", after.opens.withOffset(zone), after.due.withOffset(zone))
        }
        return after
    }

    private fun <T> changed(
        field: RuleField,
        before: T?,
        read: RuleField.(String) -> T,
    ): T? {
        val text = told[field] ?: return before
        return text.trim().takeIf { it.isNotEmpty() }?.let { field.read(it) }
    }

    companion object {
        private const val MOST_DAYS = 60
        private const val MOST_ATTEMPTS = 1_000
        private val YEARS = 2000..9999

        /**
         * The moment that a text means: with an offset, or a time of that zone. Of an hour that comes twice it is the
         * one that leaves students more time.
         *
         * @param field that holds it, for the message
         * @param held the moment before, which stays where the text is its time of day
         * @param begins whether something begins then, and not ends
         * @throws Rejection.BadRule where there is no such moment
         */
        fun moment(
            field: String,
            text: String,
            zone: ZoneId,
            held: Instant? = null,
            begins: Boolean = false,
        ): Instant {
            val moment =
                try {
                    OffsetDateTime.parse(text).toInstant()
                } catch (noOffset: DateTimeException) {
                    localTime(field, text, zone, held, begins)
                }
            return moment.takeIf { it.atZone(zone).year in YEARS } ?: throw noMoment(field, text, zone)
        }

        private fun localTime(
            field: String,
            text: String,
            zone: ZoneId,
            held: Instant?,
            begins: Boolean,
        ): Instant {
            val local =
                try {
                    LocalDateTime.parse(text)
                } catch (invalid: DateTimeException) {
                    throw noMoment(field, text, zone)
                }
            if (held != null && held.atZone(zone).toLocalDateTime() == local) return held
            zone.rules.getTransition(local)?.takeIf { it.isGap }?.let { gap ->
                val example = local.atOffset(gap.offsetBefore)
                throw Rejection.BadRule(
                    "gap",
                    field,
                    text,
                    zone.named(),
                    "${gap.dateTimeBefore}",
                    "${gap.dateTimeAfter}",
                    "$example",
                )
            }
            val at = local.atZone(zone)
            return (if (begins) at.withEarlierOffsetAtOverlap() else at.withLaterOffsetAtOverlap()).toInstant()
        }

        private fun noMoment(
            field: String,
            text: String,
            zone: ZoneId,
        ) = Rejection.BadRule("moment", field, text, zone.named())

        private fun zone(text: String): ZoneId =
            try {
                ZoneId.of(text.trim())
            } catch (invalid: DateTimeException) {
                throw Rejection.BadRule("zone", text)
            }

        /** @param fault the words that say what is allowed, and what nothing means */
        private fun number(
            field: RuleField,
            text: String,
            allowed: IntRange,
            fault: String = "number",
        ): Int =
            text.toIntOrNull()?.takeIf { it in allowed }
                ?: throw Rejection.BadRule(fault, field.code, text, allowed.first, allowed.last)

        private fun policy(text: String): CountingPolicy =
            CountingPolicy.entries.firstOrNull { it.code == text }
                ?: throw Rejection.BadRule("policy", text, CountingPolicy.entries.joinToString { it.code })
    }
}
