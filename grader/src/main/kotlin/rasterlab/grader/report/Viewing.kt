/*
 * Results for readers: each sees of a recorded report what Viewing leaves of it, at once or as it grows.
 * Read Viewing, then ReportRoutes.
 */
package rasterlab.grader.report

import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.Transient
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import rasterlab.exercises.published.ManualPoints
import rasterlab.exercises.published.PublishedCase
import rasterlab.exercises.published.PublishedDiagnostic
import rasterlab.exercises.published.PublishedPart
import rasterlab.exercises.published.PublishedPoints
import rasterlab.exercises.published.PublishedSpeed
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.SpeedFigures
import rasterlab.exercises.topic.CaseRules.CaseRule
import rasterlab.grader.course.Identity
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.storage.text
import rasterlab.grader.submission.QueuePlace
import rasterlab.grader.submission.Recorded
import rasterlab.grader.submission.State
import rasterlab.grader.submission.Submission
import java.time.Instant
import kotlin.jvm.optionals.getOrNull

/**
 * @param revision of the exercise that it was or will be graded against
 * @param current whether that is the exercise as it is now
 * @param waitSeconds until it is graded, as estimated; null when it does not wait, or nothing is known
 * @param late whether it was handed in after the deadline
 * @param penalty percent of its points that it loses for that
 * @param opened whether nobody in the course can hand in for points any more, so that hidden cases answer in full
 * @param opensLater whether that is so at another moment than the deadline
 */
@Serializable
data class SubmissionView(
    val id: String,
    val exercise: String,
    val revision: String,
    val current: Boolean,
    val attempt: Int,
    val state: String,
    val position: Int,
    val waitSeconds: Int?,
    val verdict: String?,
    @Serializable(with = PointsAsPublished::class) val points: PublishedPoints?,
    val cases: List<
        @Serializable(with = CaseAsPublished::class)
        PublishedCase,
    >,
    val diagnostics: List<
        @Serializable(with = DiagnosticAsPublished::class)
        PublishedDiagnostic,
    >,
    val isolation: String?,
    @Serializable(with = SpeedAsPublished::class) val speed: PublishedSpeed?,
    val receivedAt: String,
    val gradedAt: String?,
    val deadline: String?,
    val late: Boolean,
    val penalty: Int,
    val opened: Boolean,
    @Transient val opensLater: Boolean = false,
)

/** @param current whether that revision is the exercise as it is now */
class GradedAgainst(
    val revision: String,
    val current: Boolean,
)

/**
 * The effect of the deadline on a submission.
 *
 * @param at the deadline, or null where there is none
 * @param late whether it was handed in after it, and after the one that held then
 * @param passed whether nobody in the course can hand in for points any more, so that hidden cases answer in full
 * @param opensLater whether they do so at another moment than the deadline
 */
class Due(
    val at: Instant?,
    val late: Boolean,
    val passed: Boolean,
    val opensLater: Boolean,
) {
    companion object {
        /**
         * A submission of the exact moment is in time.
         *
         * @param rules that hold for the student
         * @param shows the moment after which hidden cases answer with everything; null for never
         */
        fun of(
            rules: ExerciseRules,
            shows: Instant?,
            submission: Submission,
            now: Instant,
        ) = Due(
            rules.due,
            late = listOf(rules.due, submission.dueAt).all { it != null && submission.receivedAt > it },
            passed = shows != null && now > shows,
            opensLater = shows != rules.due,
        )
    }
}

/**
 * The words beside a case, in one language.
 *
 * @param address under which its pictures are; null for that of the submission
 */
class CaseWords(
    val language: String,
    val title: (CaseReport) -> String,
    val reason: (CaseReport) -> String?,
    val rule: (CaseReport) -> CaseRule? = { null },
    val address: String? = null,
)

/** A part of a published report in our JSON, as it writes itself. */
abstract class AsPublished<T : PublishedPart> : KSerializer<T> {
    private val json = JsonElement.serializer()
    override val descriptor = json.descriptor

    override fun serialize(
        encoder: Encoder,
        value: T,
    ) = encoder.encodeSerializableValue(json, Json.parseToJsonElement(value.json()))

    override fun deserialize(decoder: Decoder): T = throw SerializationException("a report is written, not read")
}

object PointsAsPublished : AsPublished<PublishedPoints>()

object SpeedAsPublished : AsPublished<PublishedSpeed>()

object CaseAsPublished : AsPublished<PublishedCase>()

object DiagnosticAsPublished : AsPublished<PublishedDiagnostic>()

/** The part of a report that this viewer may see. */
fun Report.seenBy(
    who: Identity,
    due: Due,
): Report = if (who is Identity.StudentIdentity) forStudent(due.passed) else this

fun CaseReport.seenBy(
    who: Identity,
    due: Due,
): CaseReport = if (who is Identity.StudentIdentity) forStudent(due.passed) else this

/**
 * @param recorded with nothing hidden; null as long as there is no result
 * @param against what the result was, or will be, graded against
 * @param manual what staff gave or took beside the points of grading
 * @param speed puts figures on the topic's chart; null where the topic is not known any more
 */
fun Submission.view(
    who: Identity,
    place: QueuePlace,
    running: List<CaseReport>,
    recorded: Recorded?,
    against: GradedAgainst,
    due: Due,
    words: CaseWords,
    manual: List<ManualPoints>,
    speed: (SpeedFigures) -> PublishedSpeed?,
): SubmissionView {
    // Row and result are read one after the other, so a result may be there that the row does not know of yet.
    val report = recorded?.report?.seenBy(who, due)
    val cases = report?.cases() ?: running.map { it.seenBy(who, due) }
    return SubmissionView(
        id,
        exercise,
        against.revision,
        against.current,
        attempt,
        (if (report == null) state else State.DONE).code,
        if (report == null) place.position else 0,
        if (report == null) place.waitSeconds else null,
        report?.verdict()?.code(),
        report?.points()?.let { PublishedPoints.of(it, hintCost, penalty, manual) },
        cases.map { it.view(id, words) },
        report?.diagnostics().orEmpty().map { PublishedDiagnostic.of(it, words.language) },
        report?.isolation(),
        report?.figures()?.getOrNull()?.let { speed(it) },
        receivedAt.text(),
        recorded?.gradedAt?.text(),
        due.at?.text(),
        due.late,
        penalty,
        due.passed,
        due.opensLater,
    )
}

fun CaseReport.view(
    submission: String,
    words: CaseWords,
): PublishedCase {
    val folder = "${words.address ?: "/api/v1/submissions/$submission"}/cases/${name()}"
    val case =
        PublishedCase.of(this, words.language, words.title(this)) {
            val asked = if (it.file().hasOwn(words.language)) "?lang=${words.language}" else ""
            "$folder/${it.kind()}.png$asked"
        }
    val ruled = words.rule(this)?.let { case.under(it, words.language) } ?: case
    return words.reason(this)?.let(ruled::because) ?: ruled
}
