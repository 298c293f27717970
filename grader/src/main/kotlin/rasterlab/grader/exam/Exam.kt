// Exams: a window of time in which a student has some exercises and nothing else. Start with Exam, then see Exams.
package rasterlab.grader.exam

import rasterlab.grader.rules.RepeatedHour
import java.time.Duration
import java.time.Instant
import java.time.ZoneId

/**
 * An exam of a course.
 *
 * @param course id
 * @param exercises their ids, in order
 * @param opens nobody begins before
 * @param closes nobody works on after, but for more time that a student was given
 * @param zone in which its times are typed
 * @param minutes that a student has
 * @param fixed whether these begin for all at [opens]; otherwise when the student opens the exam
 * @param grace seconds after the end in which work is still taken that was on its way
 * @param addresses from which it can be opened
 * @param takesOver whether a second session ends the first; otherwise it is refused
 */
data class Exam(
    val id: String,
    val course: String,
    val name: String,
    val exercises: List<String>,
    val opens: Instant,
    val closes: Instant,
    val zone: ZoneId,
    val minutes: Int,
    val fixed: Boolean,
    val grace: Int,
    val addresses: AddressList,
    val takesOver: Boolean,
) {
    init {
        require(exercises.isNotEmpty()) { "an exam needs an exercise" }
        require(opens < closes) { "the exam opens at $opens, but closes at $closes" }
        require(minutes in MINUTES) { "$minutes minutes, expected $MINUTES" }
        require(grace in GRACE) { "$grace seconds of grace, expected $GRACE" }
    }

    /** The end for somebody who begins at a moment and has some minutes more than others. */
    fun ends(
        started: Instant,
        extra: Int,
    ): Instant = minOf(started + Duration.ofMinutes(minutes.toLong()), closes) + Duration.ofMinutes(extra.toLong())

    /** The moment after which nobody works on it who has at most so many minutes more than others. */
    fun over(extra: Int): Instant = closes + Duration.ofMinutes(extra.toLong()) + Duration.ofSeconds(grace.toLong())

    /** Lists its times that the clocks of its zone show twice. */
    fun repeatedHours(): List<RepeatedHour> =
        RepeatedHour.among(zone, ExamField.OPENS.code to opens, ExamField.CLOSES.code to closes)

    companion object {
        val MINUTES = 1..1_440
        val EXTRA = 0..1_440
        val GRACE = 0..600
    }
}

/** Tells how far a student is with an exam. */
enum class SittingState {
    WAITING,
    READY,
    RUNNING,
    OVER,
    ;

    /** Lower-case, as the texts' keys have it. */
    val code get() = name.lowercase()
}

/**
 * A student at an exam.
 *
 * @param extra minutes more than others have
 * @param started when the student opened it; null where they did not yet
 * @param ended when it was ended, by the student or by time; null where it was not
 * @param session hash of the one that may work on it; null where the next one may
 */
data class Sitting(
    val exam: Exam,
    val student: String,
    val extra: Int,
    val started: Instant?,
    val ended: Instant?,
    val session: String?,
    val address: String?,
) {
    init {
        require(extra in Exam.EXTRA) { "$extra more minutes, expected ${Exam.EXTRA}" }
    }

    /** The student's last moment; null where that is not known before they begin. */
    val ends: Instant? =
        if (exam.fixed) exam.ends(exam.opens, extra) else started?.let { exam.ends(it, extra) }

    /** The last moment in which work is taken that was on its way. */
    val taken: Instant? = ends?.plusSeconds(exam.grace.toLong())

    fun state(now: Instant): SittingState =
        when {
            ended != null || now > (taken ?: exam.closes) -> SittingState.OVER
            started != null -> SittingState.RUNNING
            now < exam.opens -> SittingState.WAITING
            else -> SittingState.READY
        }

    /** Whether the student has nothing but this exam now: it runs, or has begun for all. */
    fun holds(now: Instant): Boolean =
        when (state(now)) {
            SittingState.RUNNING -> true
            SittingState.READY -> exam.fixed
            SittingState.WAITING, SittingState.OVER -> false
        }

    /** The seconds that are left; 0 where time is over. */
    fun left(now: Instant): Long = ends?.let { maxOf(0, Duration.between(now, it).toSeconds()) } ?: (exam.minutes * 60L)
}
