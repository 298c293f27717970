// What a course rules for an exercise: when it is open, how often to hand in, what counts. Start with ExerciseRules.
package rasterlab.grader.rules

import rasterlab.grader.problem.Rejection
import java.sql.ResultSet
import java.time.Instant
import java.time.ZoneId
import java.time.ZoneOffset

/** Which of the submissions of a student counts. */
enum class CountingPolicy {
    BEST,
    LAST,
    CHOSEN,
    ;

    /** Lower-case, as in the HTTP API. */
    val code get() = name.lowercase()
}

/** Tells a submission by when it came. Late with a day to spend counts as late does; practice counts no more. */
enum class Arrival {
    IN_TIME,
    LATE,
    LATE_DAY,
    PRACTICE,
}

/** The id of a zone, UTC by that name. */
fun ZoneId.named(): String = if (this == ZoneOffset.UTC) "UTC" else id

/**
 * The rules of one exercise, for a course or, with a later deadline, for one of its students.
 *
 * @param opens nothing is taken before; null where it is open already
 * @param due the last moment that is not late; null for none
 * @param zone by which late days are counted, and times are shown to those who set them
 * @param lateDays how long after [due] a submission counts; null for any time
 * @param attempts how many submissions there may be that count; null for any number
 */
data class ExerciseRules(
    val opens: Instant? = null,
    val due: Instant? = null,
    val zone: ZoneId = ZoneOffset.UTC,
    val lateDays: Int? = null,
    val attempts: Int? = null,
    val policy: CountingPolicy = CountingPolicy.BEST,
) {
    /** The last moment of what counts, at the deadline's time of day in its zone; null where everything does. */
    val closes: Instant? = lateDays?.let(::lateDayEnds)

    /** The moment after which nothing comes that counts, or it is marked as late; null for none. */
    val ends: Instant? = closes ?: due

    /** These rules with this deadline where it is later: what was in time when it came stays so. */
    fun orDue(then: Instant?): ExerciseRules =
        if (due != null &&
            (then == null || then > due)
        ) {
            copy(due = then)
        } else {
            this
        }

    fun arrival(at: Instant): Arrival =
        when {
            due == null || at <= due -> Arrival.IN_TIME
            closes == null -> Arrival.LATE
            at <= closes -> Arrival.LATE_DAY
            else -> Arrival.PRACTICE
        }

    /** The number, from 1, of the late day that a submission of this moment takes; 0 where it takes none. */
    fun lateDay(at: Instant): Int =
        if (arrival(at) != Arrival.LATE_DAY) 0 else (1..(lateDays ?: 0)).first { at <= checkNotNull(lateDayEnds(it)) }

    /** Tells what becomes of work that comes at this moment; null where it is in time. */
    fun lateness(at: Instant): Rejection.Lateness? =
        when (arrival(at)) {
            Arrival.IN_TIME -> null
            Arrival.LATE -> Rejection.Lateness.Marked()
            Arrival.LATE_DAY -> Rejection.Lateness.TakesDay(lateDay(at), checkNotNull(lateDays), checkNotNull(closes))
            Arrival.PRACTICE -> Rejection.Lateness.Practice(checkNotNull(closes))
        }

    private fun lateDayEnds(day: Int): Instant? = due?.atZone(zone)?.plusDays(day.toLong())?.toInstant()

    companion object {
        /** The deadline of a student in rows `rules` and `extensions`: an extension never shortens. */
        const val DUE = "CASE WHEN extensions.due_at > rules.due_at THEN extensions.due_at ELSE rules.due_at END"

        /** The columns that [of] reads, for a student. */
        const val COLUMNS = "rules.opens_at, $DUE AS due_at, rules.zone, rules.late_days, rules.attempts, rules.policy"

        /** The rules in a row; no rules where an outer join found none. */
        fun of(row: ResultSet) =
            ExerciseRules(
                row.getString("opens_at")?.let(Instant::parse),
                row.getString("due_at")?.let(Instant::parse),
                row.getString("zone")?.let(ZoneId::of) ?: ZoneOffset.UTC,
                row.getInt("late_days").takeUnless { row.wasNull() },
                row.getInt("attempts").takeUnless { row.wasNull() },
                row.getString("policy")?.let { CountingPolicy.valueOf(it.uppercase()) } ?: CountingPolicy.BEST,
            )
    }
}
