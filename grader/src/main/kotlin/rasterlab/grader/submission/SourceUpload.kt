package rasterlab.grader.submission

import io.ktor.http.ContentType
import io.ktor.http.content.PartData
import io.ktor.http.content.forEachPart
import io.ktor.server.application.ApplicationCall
import io.ktor.server.request.contentLength
import io.ktor.server.request.receiveMultipart
import io.ktor.utils.io.readRemaining
import kotlinx.io.IOException
import kotlinx.io.readByteArray
import rasterlab.exercises.Grading
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.bodyType
import rasterlab.grader.problem.inTime
import rasterlab.grader.problem.receiveAtMost
import rasterlab.grader.problem.utf8

const val LONGEST_SOURCE_BYTES = Grading.MOST_SOURCE_BYTES
private const val FORM_EXTRA_BYTES = 16 * 1024
private val JAVA_SOURCE = ContentType("text", "x-java-source")

/** The source in the body: alone, or the multipart field `source`. */
suspend fun ApplicationCall.receiveSource(): String {
    val type = bodyType(JAVA_SOURCE, ContentType.MultiPart.FormData)
    if (type == JAVA_SOURCE) return sourceOf(receiveAtMost(LONGEST_SOURCE_BYTES))
    return sourceOf(receiveFields()["source"]?.firstOrNull() ?: ByteArray(0))
}

/** Bytes of a source as text. */
fun sourceOf(bytes: ByteArray): String {
    if (bytes.size > LONGEST_SOURCE_BYTES) throw Rejection.TooLarge(LONGEST_SOURCE_BYTES)
    val text = utf8(bytes, Rejection::NotUtf8)
    if (text.isBlank()) throw Rejection.EmptySource()
    return text
}

/** The fields of a form, each with the bytes of its values in order. */
suspend fun ApplicationCall.receiveFields(): Map<String, List<ByteArray>> {
    bodyType(ContentType.MultiPart.FormData)
    val limit = 2 * LONGEST_SOURCE_BYTES + FORM_EXTRA_BYTES
    if ((request.contentLength() ?: 0) > limit) receiveAtMost(limit)
    val fields = mutableMapOf<String, MutableList<ByteArray>>()
    var left = limit
    try {
        inTime {
            receiveMultipart(formFieldLimit = limit.toLong()).forEachPart { part ->
                val bytes = part.bytes(left)
                left -= bytes.size
                if (left < 0) throw Rejection.TooLarge(limit)
                fields.getOrPut(part.name.orEmpty()) { mutableListOf() } += bytes
                part.release()
            }
        }
    } catch (failure: IOException) {
        throw Rejection.Malformed("the form cannot be read")
    }
    return fields
}

/** At most one byte more than [limit]. */
private suspend fun PartData.bytes(limit: Int) =
    when (this) {
        is PartData.FormItem -> value.toByteArray()
        is PartData.FileItem -> provider().readRemaining(limit + 1L).readByteArray()
        else -> ByteArray(0)
    }
