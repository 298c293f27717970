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

/** Tells a submission by when it came. What is late may cost points; late with a day to spend costs none; practice does not count. */
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
 * @param lateDays how long after [due] a submission counts as it is; null for any time
 * @param latePenalty percent of its points that a submission loses for each day begun after the late days; it counts until
 *     nothing would be left. 0 for no such days
 * @param attempts how many submissions there may be that count; null for any number
 */
data class ExerciseRules(
    val opens: Instant? = null,
    val due: Instant? = null,
    val zone: ZoneId = ZoneOffset.UTC,
    val lateDays: Int? = null,
    val attempts: Int? = null,
    val policy: CountingPolicy = CountingPolicy.BEST,
    val latePenalty: Int = 0,
) {
    init {
        require(latePenalty in PERCENT) { "late penalty $latePenalty, expected a percentage from 0 to 100" }
    }

    /** The late days that cost nothing; null for any number. */
    val freeDays: Int? = if (latePenalty > 0) lateDays ?: 0 else lateDays

    /** The last moment of the late days, at the deadline's time of day in its zone; null where they do not end. */
    val free: Instant? = freeDays?.let(::lateDayEnds)

    /** The last moment of what counts; null where everything does. */
    val closes: Instant? = freeDays?.let { lateDayEnds(it + costlyDays()) }

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
            free != null && at <= free -> Arrival.LATE_DAY
            closes == null || at <= closes -> Arrival.LATE
            else -> Arrival.PRACTICE
        }

    /** The number, from 1, of the late day that a submission of this moment takes; 0 where it takes none. */
    fun lateDay(at: Instant): Int = if (arrival(at) != Arrival.LATE_DAY) 0 else dayOf(at)

    /** The percentage of its points that a submission of this moment loses; 0 where it loses none, or does not count. */
    fun penalty(at: Instant): Int =
        if (latePenalty == 0 || arrival(at) != Arrival.LATE) 0 else latePenalty * (dayOf(at) - checkNotNull(freeDays))

    /** Tells what becomes of work that comes at this moment; null where it is in time. */
    fun lateness(at: Instant): Rejection.Lateness? =
        when (arrival(at)) {
            Arrival.IN_TIME -> null
            Arrival.LATE -> late(penalty(at))
            Arrival.LATE_DAY -> Rejection.Lateness.TakesDay(lateDay(at), checkNotNull(lateDays), checkNotNull(free))
            Arrival.PRACTICE -> Rejection.Lateness.Practice(checkNotNull(closes))
        }

    private fun late(penalty: Int) =
        if (penalty == 0) Rejection.Lateness.Marked() else Rejection.Lateness.TakesPoints(penalty, checkNotNull(closes))

    /** How many days may be paid for before nothing is left. */
    private fun costlyDays() = if (latePenalty == 0) 0 else (PERCENT.last - 1) / latePenalty

    /** The day after the deadline, from 1, in which a moment lies that counts. */
    private fun dayOf(at: Instant): Int =
        (1..checkNotNull(freeDays) + costlyDays()).first { at <= checkNotNull(lateDayEnds(it)) }

    private fun lateDayEnds(day: Int): Instant? = due?.atZone(zone)?.plusDays(day.toLong())?.toInstant()

    companion object {
        /** The percentages that a rule may name. */
        val PERCENT = 0..100

        /** The deadline of a student in rows `rules` and `extensions`: an extension never shortens. */
        const val DUE = "CASE WHEN extensions.due_at > rules.due_at THEN extensions.due_at ELSE rules.due_at END"

        /** The columns that [of] reads, for a student. */
        const val COLUMNS =
            """rules.opens_at, $DUE AS due_at, rules.zone, rules.late_days, rules.attempts, rules.policy,
               rules.late_penalty"""

        /** The rules in a row; no rules where an outer join found none. */
        fun of(row: ResultSet) =
            ExerciseRules(
                row.getString("opens_at")?.let(Instant::parse),
                row.getString("due_at")?.let(Instant::parse),
                row.getString("zone")?.let(ZoneId::of) ?: ZoneOffset.UTC,
                row.getInt("late_days").takeUnless { row.wasNull() },
                row.getInt("attempts").takeUnless { row.wasNull() },
                row.getString("policy")?.let { CountingPolicy.valueOf(it.uppercase()) } ?: CountingPolicy.BEST,
                row.getInt("late_penalty"),
            )
    }
}
