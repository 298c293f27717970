package rasterlab.grader.submission

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.server.application.ApplicationCall
import io.ktor.server.request.contentType
import rasterlab.exercises.Exercise.TaskKind
import rasterlab.exercises.Grading
import rasterlab.exercises.SourceEncoding
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.bodyType
import rasterlab.grader.problem.receiveAtMost
import rasterlab.grader.problem.utf8

const val LONGEST_SOURCE_BYTES = Grading.MOST_SOURCE_BYTES
private const val FORM_EXTRA_BYTES = 16 * 1024
private const val KOTLIN = "text/x-kotlin"

private class SourceTooLarge : Rejection.TooLarge(LONGEST_SOURCE_BYTES) {
    override val pageText get() = "$code.source"
}

/** The text that is handed in, in the body: alone, or as the multipart field `source`. */
suspend fun ApplicationCall.receiveSource(form: TaskKind): String {
    if (request.headers[HttpHeaders.ContentType].orEmpty().startsWith(KOTLIN)) throw Rejection.Kotlin()
    val alone = ContentType.parse(form.mediaType())
    if (bodyType(alone, ContentType.MultiPart.FormData) == alone) {
        return sourceOf(receiveAtMost(LONGEST_SOURCE_BYTES, ::SourceTooLarge))
    }
    return sourceOf(receiveFields())
}

/** Bytes of a source as text. */
fun sourceOf(bytes: ByteArray): String {
    if (bytes.size > LONGEST_SOURCE_BYTES) throw SourceTooLarge()
    val text = utf8(bytes) { Rejection.NotUtf8(it, SourceEncoding.of(bytes)) }
    if (text.isBlank()) throw Rejection.EmptySource()
    return text
}

/** The fields of a form, in order; its files and texts may have [most] bytes together. */
internal suspend fun ApplicationCall.receiveFields(
    most: Int = 2 * LONGEST_SOURCE_BYTES,
    tooLarge: () -> Rejection = ::SourceTooLarge,
): List<FormField> {
    bodyType(ContentType.MultiPart.FormData)
    return formFields(receiveAtMost(most + FORM_EXTRA_BYTES, tooLarge), request.contentType())
}

/** The content of the form's field `source`; of several, the first that is not empty. */
internal fun sourceOf(fields: List<FormField>): String {
    val sources = fields.filter { it.name == "source" }
    val sent = sources.firstOrNull { it.content.isNotEmpty() } ?: throw Rejection.EmptySource()
    if (sent.file
            .orEmpty()
            .lowercase()
            .let { it.endsWith(".kt") || it.endsWith(".kts") }
    ) {
        throw Rejection.Kotlin()
    }
    return sourceOf(sent.content)
}
