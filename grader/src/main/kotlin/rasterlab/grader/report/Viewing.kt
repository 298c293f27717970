/*
 * Results for readers: each sees of a recorded report what Viewing leaves of it, at once or as it grows.
 * Read Viewing, then ReportRoutes.
 */
package rasterlab.grader.report

import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.PicturePart
import rasterlab.exercises.score.PixelRows
import rasterlab.exercises.score.PublishedVerdict
import rasterlab.exercises.score.Report
import rasterlab.grader.course.Identity
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Recorded
import rasterlab.grader.submission.State
import rasterlab.grader.submission.Submission
import java.util.Optional
import kotlin.jvm.optionals.getOrNull

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
    val points: PointsView?,
    val cases: List<CaseView>,
    val diagnostics: List<DiagnosticView>,
    val isolation: String?,
    val receivedAt: String,
    val gradedAt: String?,
)

/** @param current whether that revision is the exercise as it is now */
class GradedAgainst(
    val revision: String,
    val current: Boolean,
)

@Serializable
data class PointsView(
    val accuracy: Int,
    val stability: Int,
    val speed: Int,
    val total: Int,
    val of: Int,
)

/**
 * @param run false where the method was stopped before the case's turn came: `verdict` is `no_result` then
 * @param place in the answer that the message tells in words, as a path of its JSON; null where it tells none
 */
@Serializable
data class CaseView(
    val name: String,
    val title: String,
    val visibility: String,
    val run: Boolean,
    val verdict: String,
    val points: Int,
    val of: Int,
    val message: String,
    val place: String?,
    val pictures: List<PictureView>,
    val scene: JsonElement?,
)

/**
 * @param kind of the picture; whoever does not know it shows the picture under this name
 * @param url where the PNG is
 * @param text tells people who do not see it what is there, in their language; of a grid of pixels its rows
 * @param part which pixels of a grid these are; null where it is no grid, and where an older server drew it
 */
@Serializable
data class PictureView(
    val kind: String,
    val url: String,
    val text: String,
    @Serializable(with = PartAsJson::class) val part: PicturePart?,
) {
    /** The rows of characters alone; none where it is no grid of pixels. */
    fun rows(): List<String> = PixelRows.of(text, Optional.ofNullable(part))
}

/** As the part itself writes it. */
private object PartAsJson : KSerializer<PicturePart> {
    private val json = JsonElement.serializer()
    override val descriptor = json.descriptor

    override fun serialize(
        encoder: Encoder,
        value: PicturePart,
    ) = encoder.encodeSerializableValue(json, Json.parseToJsonElement(value.data()))

    override fun deserialize(decoder: Decoder): PicturePart =
        PicturePart.ofData(decoder.decodeSerializableValue(json).toString()).orElseThrow()
}

@Serializable
data class DiagnosticView(
    val line: Int,
    val column: Int,
    val message: String,
)

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
        report?.points()?.let { PointsView(it.accuracy(), it.stability(), it.speed(), it.total(), it.of()) },
        cases.map { it.view(id, language, title(it.name())) },
        report?.diagnostics().orEmpty().map { DiagnosticView(it.line(), it.column(), it.message(language)) },
        report?.isolation(),
        receivedAt.text(),
        recorded?.gradedAt?.text(),
    )
}

fun CaseReport.view(
    submission: String,
    language: String,
    title: String,
): CaseView {
    val folder = "/api/v1/submissions/$submission/cases/${name()}"
    val pictures =
        pictures().map {
            PictureView(it.kind(), "$folder/${it.kind()}.png", it.text().`in`(language), it.part().getOrNull())
        }
    val verdict = PublishedVerdict.of(verdict())
    val scene = scene().takeIf { it.isNotEmpty() }?.let(Json::parseToJsonElement)
    return CaseView(
        name(),
        title,
        visibility().code(),
        verdict.run(),
        verdict.code(),
        points(),
        of(),
        message(language),
        place().getOrNull(),
        pictures,
        scene,
    )
}
