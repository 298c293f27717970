// Every way to say no, and how it is shown. A handler throws a Rejection; Problems.kt turns it into an answer.
package rasterlab.grader.problem

import rasterlab.exercises.CatalogueException
import rasterlab.exercises.SourceEncoding
import rasterlab.grader.limits.Allowance
import rasterlab.grader.wording.Wording
import java.time.Instant
import java.util.Locale

/**
 * Why the server does not do what it was asked.
 *
 * @param message for whoever asked, in English
 * @param code names the kind of failure to programs and to the page texts
 */
sealed class Rejection(
    override val message: String,
    val code: String,
) : Exception(message) {
    /** The limit that was met, or null where it was none. */
    open val allowance: Allowance? = null

    /** Names the text that a page shows: the code, or more exactly what was met. */
    open val pageText get() = code

    /** The sentences that a page adds to that text, in its language. */
    open fun details(language: String): List<String> = emptyList()

    class NotSignedIn :
        Rejection("needs the header 'Authorization: Bearer TOKEN' with a token of this server", "not-signed-in")

    class WrongRole(
        needed: String,
    ) : Rejection("only for the role '$needed'", "wrong-role")

    class ForeignOrigin : Rejection("the form was not sent from a page of this server", "foreign-origin")

    class UnknownExercise(
        id: String,
    ) : Rejection("no exercise called '$id'", "unknown-exercise")

    /** The submission is unknown, or that of somebody else, so that its id tells nothing. */
    class UnknownSubmission(
        id: String,
    ) : Rejection("no submission '$id' of yours", "unknown-submission")

    class UnknownPicture(
        of: String,
        picture: String,
    ) : Rejection("no picture '$picture' of '$of'", "unknown-picture")

    /** The case has no scene, or is hidden. */
    class UnknownScene(
        case: String,
    ) : Rejection("no scene of a case '$case'", "unknown-scene")

    class UnknownCourse(
        code: String,
    ) : Rejection("no course with the code '$code'", "unknown-course")

    class UnknownStudent(
        val id: String,
    ) : Rejection("no student '$id'", "unknown-student")

    class UnknownStaff(
        val id: String,
    ) : Rejection("no instructor or assistant '$id'", "unknown-staff")

    class UnknownWorker(
        name: String,
    ) : Rejection("nobody who grades is called '$name'", "unknown-worker")

    /** The only instructor keeps the access: nobody else could give any. */
    class LastInstructor :
        Rejection("this is the only instructor who has access; add another one first", "last-instructor")

    class Malformed(
        detail: String,
    ) : Rejection(detail, "malformed-request")

    class BadName(
        what: String,
        limit: Int,
    ) : Rejection("'$what' must have 1 to $limit visible characters and no control characters", "bad-name")

    /** @param secret whether the key alone gets the answer again */
    class BadKey(
        length: Int,
        allowed: IntRange,
        secret: Boolean,
    ) : Rejection(
            "Idempotency-Key must have ${allowed.first} to ${allowed.last} printable ASCII characters, not spaces; " +
                "it has $length" +
                if (secret) "; whoever repeats it here gets the token, so it must be hard to guess" else "",
            "bad-idempotency-key",
        )

    class KeyReused : Rejection("this Idempotency-Key was used for a different request", "idempotency-key-reused")

    class EmptySource :
        Rejection("the source is empty; it is the whole body, or the field 'source' of a form", "empty-source")

    /**
     * Something of an instructor's that cannot be taken; its words stand in a file for each language.
     *
     * @param words name of the file
     * @param fault key of the words
     */
    sealed class Explained(
        private val words: String,
        private val fault: String,
        private val values: Array<out Any>,
        code: String,
    ) : Rejection(explained(words, fault, Locale.ENGLISH, values), code) {
        override fun details(language: String) = listOf(said(Locale.forLanguageTag(language)))

        fun said(language: Locale): String = explained(words, fault, language, values)

        private companion object {
            fun explained(
                words: String,
                fault: String,
                language: Locale,
                values: Array<out Any>,
            ) = Wording("rasterlab.grader.problem.$words", language).say(fault, *values)
        }
    }

    /** A roster that cannot be read, or not without a doubt; nothing is stored. */
    class BadRoster(
        fault: String,
        vararg values: Any,
    ) : Explained("roster", fault, values, "bad-roster")

    /** A rule of an exercise that cannot hold; nothing is stored. */
    class BadRule(
        fault: String,
        vararg values: Any,
    ) : Explained("rules", fault, values, if ("deadline" in values) "bad-deadline" else "bad-rule")

    /** A choice of submissions to grade again that there are none of; nothing is begun. */
    class BadRegrade(
        fault: String,
        vararg values: Any,
    ) : Explained("regrades", fault, values, "bad-regrade")

    /** A regrade is not in a state in which what was asked can be done. */
    class RegradeStands(
        fault: String,
        vararg values: Any,
    ) : Explained("regrades", fault, values, "regrade-stands")

    /** Points that cannot be given or taken so; nothing is changed. */
    class BadAdjustment(
        fault: String,
        vararg values: Any,
    ) : Explained("adjustments", fault, values, "bad-adjustment")

    class UnknownAdjustment(
        id: String,
    ) : Explained("adjustments", "unknown", arrayOf(id), "unknown-adjustment")

    /** An exam that cannot be; nothing is stored. */
    class BadExam(
        fault: String,
        vararg values: Any,
    ) : Explained("exams", fault, values, "bad-exam")

    /** A registration of a learning platform that cannot be; nothing is stored. */
    class BadPlatform(
        fault: String,
        vararg values: Any,
    ) : Explained("platforms", fault, values, "bad-platform")

    class UnknownPlatform(
        val id: String,
    ) : Rejection("no learning platform '$id'", "unknown-platform")

    class UnknownExam(
        id: String,
    ) : Rejection("no exam '$id'", "unknown-exam")

    /** The student has an exam now, and nothing beside. */
    class InExam(
        exam: String,
    ) : Rejection("while the exam '$exam' runs, there is nothing but it; see /exams", "in-exam")

    class ExamNotOpen(
        exam: String,
    ) : Rejection("the exam '$exam' is not open, or you have not opened it", "exam-not-open")

    class ExamOver(
        exam: String,
    ) : Rejection("the exam '$exam' is over", "exam-over")

    class ExamAddress(
        address: String,
    ) : Rejection("the exam cannot be opened from the address $address", "exam-address")

    /** Says that the exam is open in another browser or program, or that staff let the next one in, which has to open it. */
    class OtherSession : Rejection("another session has this exam; staff can release it", "other-session")

    class UnknownRegrade(
        id: String,
    ) : Explained("regrades", "unknown", arrayOf(id), "unknown-regrade")

    /** A comment that cannot be written or changed so; nothing is changed. */
    class BadComment(
        fault: String,
        vararg values: Any,
    ) : Explained("comments", fault, values, "bad-comment")

    /** The comment is none of this submission, or not kept in this course. */
    class UnknownComment(
        id: String,
    ) : Explained("comments", "unknown", arrayOf(id), "unknown-comment")

    class UnknownGroup(
        id: String,
    ) : Explained("comments", "group", arrayOf(id), "unknown-group")

    class ForeignComment : Explained("comments", "foreign", emptyArray(), "foreign-comment")

    /** A complaint that cannot be opened or answered so; nothing is changed. */
    class BadComplaint(
        fault: String,
        vararg values: Any,
    ) : Explained("complaints", fault, values, "bad-complaint")

    /** The complaint is none of this submission, or of this course. */
    class UnknownComplaint(
        id: String,
    ) : Explained("complaints", "unknown", arrayOf(id), "unknown-complaint")

    /** A copy that cannot be run now; nothing is stored. */
    class BadTrial(
        fault: String,
        vararg values: Any,
    ) : Explained("trials", fault, values, "bad-trial")

    class UnknownTrial(
        id: String,
    ) : Explained("trials", "unknown", arrayOf(id), "unknown-trial")

    /** Refuses to change something where staff look at the pages as a student has them. */
    class OnlyLooks : Rejection("this is the view of a student, in which staff change nothing", "only-looks")

    /** Work came before the exercise opens. */
    class NotOpen(
        exercise: String,
        opens: Instant,
        now: Instant,
    ) : Rejection("the exercise '$exercise' opens at $opens, and it is $now", "not-open")

    /** @param limit how many submissions the course allows */
    class NoAttemptsLeft(
        exercise: String,
        limit: Int,
    ) : Rejection("all $limit attempts at '$exercise' that the course allows are used", "no-attempts-left")

    /** @param policy what counts instead */
    class NothingToChoose(
        exercise: String,
        policy: String,
    ) : Rejection("the $policy attempt at '$exercise' counts, so there is nothing to choose", "nothing-to-choose")

    /** @param likely encoding of the source */
    class NotUtf8(
        place: String,
        likely: SourceEncoding,
    ) : Rejection("the source is not UTF-8 text: $place${likely.advice()}", "not-utf-8") {
        override val pageText = "$code${likely.ending()}"

        private companion object {
            fun SourceEncoding.advice() =
                when (this) {
                    SourceEncoding.WINDOWS_1251 -> looksLike("Windows-1251 (CP1251)")
                    SourceEncoding.UTF_16 -> looksLike("UTF-16")
                    SourceEncoding.OTHER -> ""
                }

            fun looksLike(encoding: String) = "; it looks like $encoding; ${SourceEncoding.HOW_TO_SAVE}"

            fun SourceEncoding.ending() =
                if (this == SourceEncoding.OTHER) "" else ".${name.lowercase().replace('_', '-')}"
        }
    }

    class Kotlin : Rejection("Kotlin is not accepted; send Java", "kotlin")

    /** A sheet of answers that cannot be read, or is not the one of this attempt; nothing is stored. */
    class BadSheet(
        private val why: CatalogueException,
    ) : Rejection(why.`in`("en"), "bad-sheet") {
        override fun details(language: String): List<String> = why.all().map { it.`in`(language) }
    }

    /** Answers of a page's form that are none; the page says which, so nothing is stored. */
    class BadAnswers(
        count: Int,
    ) : Rejection("$count fields of the form cannot be read as answers", "bad-answers")

    /**
     * Work came after the deadline, from somebody who was not told so or did not agree.
     *
     * @param what becomes of it
     */
    class Late(
        due: Instant,
        what: Lateness,
    ) : Rejection(
            "the deadline was $due; ${what.words}: submit it again with ?late=accept if you want that",
            what.code,
        )

    /** Tells what becomes of late work. */
    sealed class Lateness(
        val words: String,
        val code: String,
    ) {
        class Marked :
            Lateness("a late submission is graded like any other, costs no points and is marked as late", "late")

        /** @param percent of the points of the submission */
        class TakesPoints(
            percent: Int,
            closes: Instant,
        ) : Lateness(
                "until $closes a submission counts, is marked as late, and now loses $percent % of its points",
                "late-cost",
            )

        class TakesDay(
            day: Int,
            of: Int,
            closes: Instant,
        ) : Lateness("until $closes a submission takes late day $day of $of, counts and is marked as late", "late-day")

        class Practice(
            closed: Instant,
        ) : Lateness("since $closed a submission is practice, which is graded and does not count", "late-practice")
    }

    /** @param steps how many the exercise has */
    class NoMoreHints(
        exercise: String,
        steps: Int,
    ) : Rejection(
            if (steps ==
                0
            ) {
                "exercise '$exercise' has no hints"
            } else {
                "all $steps hints of '$exercise' are shown already"
            },
            "no-more-hints",
        )

    class HintOrder(
        asked: Int,
        next: Int,
    ) : Rejection("hint $asked was asked for, but the next one is $next: hints come in order", "hint-order")

    class UnknownLanguage(
        asked: String,
        allowed: List<String>,
    ) : Rejection("lang is '$asked', allowed are ${allowed.joinToString()}", "unknown-language")

    class WrongMethod(
        method: String,
        path: String,
        val allowed: List<String>,
    ) : Rejection("$method is not for $path, allowed are ${allowed.joinToString()}", "method-not-allowed")

    open class TooLarge(
        limit: Int,
    ) : Rejection("the body may have at most $limit bytes", "too-large")

    class WrongMediaType(
        found: String,
        expected: String,
    ) : Rejection("Content-Type is '$found', expected $expected", "wrong-media-type")

    class TooSlow(
        seconds: Long,
    ) : Rejection("the body did not arrive within $seconds s", "too-slow")

    class TooManyQueued(
        limit: Int,
        val retryAfterSeconds: Int,
        override val allowance: Allowance,
    ) : Rejection("you already have $limit submissions waiting; wait for one to be graded", "too-many-queued")

    class TooFast(
        override val allowance: Allowance,
    ) : Rejection("at most ${allowance.limit} submissions a minute", "too-fast")

    class NoRoom : Rejection("the server's disk is full; nothing was stored, try again later", "no-room")
}
