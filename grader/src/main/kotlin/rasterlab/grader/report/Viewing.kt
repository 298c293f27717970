/*
 * Results for readers: each sees of a recorded report what Viewing leaves of it, at once or as it grows.
 * Read Viewing, then ReportRoutes.
 */
package rasterlab.grader.report

import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import rasterlab.exercises.published.PublishedCase
import rasterlab.exercises.published.PublishedDiagnostic
import rasterlab.exercises.published.PublishedPart
import rasterlab.exercises.published.PublishedPoints
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Report
import rasterlab.grader.course.Identity
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Recorded
import rasterlab.grader.submission.State
import rasterlab.grader.submission.Submission

/**
 * @param revision of the exercise that it was or will be graded against
 * @param current whether that is the exercise as it is now
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
    val receivedAt: String,
    val gradedAt: String?,
)

/** @param current whether that revision is the exercise as it is now */
class GradedAgainst(
    val revision: String,
    val current: Boolean,
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

object CaseAsPublished : AsPublished<PublishedCase>()

object DiagnosticAsPublished : AsPublished<PublishedDiagnostic>()

/** What is left of a report for these eyes. Deadlines cannot be set yet, so none has passed. */
fun Report.seenBy(who: Identity): Report = if (who is Identity.Student) forStudent(false) else this

fun CaseReport.seenBy(who: Identity): CaseReport = if (who is Identity.Student) forStudent(false) else this

/**
 * @param recorded with nothing hidden; null as long as there is no result
 * @param against what the result was, or will be, graded against
 * @param language of the messages
 * @param title of a case in that language, by its name
 */
fun Submission.view(
    who: Identity,
    position: Int,
    running: List<CaseReport>,
    recorded: Recorded?,
    against: GradedAgainst,
    language: String,
    title: (String) -> String,
): SubmissionView {
    // Row and result are read one after the other, so a result may be there that the row does not know of yet.
    val report = recorded?.report?.seenBy(who)
    val cases = report?.cases() ?: running.map { it.seenBy(who) }
    return SubmissionView(
        id,
        exercise,
        against.revision,
        against.current,
        attempt,
        (if (report == null) state else State.DONE).code,
        if (report == null) position else 0,
        report?.verdict()?.code(),
        report?.points()?.let { PublishedPoints.of(it, hintCost) },
        cases.map { it.view(id, language, title(it.name())) },
        report?.diagnostics().orEmpty().map { PublishedDiagnostic.of(it, language) },
        report?.isolation(),
        receivedAt.text(),
        recorded?.gradedAt?.text(),
    )
}

fun CaseReport.view(
    submission: String,
    language: String,
    title: String,
): PublishedCase {
    val folder = "/api/v1/submissions/$submission/cases/${name()}"
    return PublishedCase.of(this, language, title) { "$folder/${it.kind()}.png" }
}
