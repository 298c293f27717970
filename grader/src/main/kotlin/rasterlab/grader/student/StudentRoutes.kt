package rasterlab.grader.student

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondBytes
import io.ktor.server.routing.Route
import io.ktor.server.routing.delete
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import rasterlab.grader.course.instructor
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.respondJson
import java.io.ByteArrayOutputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream

@Serializable
private data class DeletedAnswer(
    val student: String,
    val submissions: Int,
)

/** Serves to instructors what is kept about a student, inside `authenticate`, and deletes it. */
fun Route.studentRecords(
    records: StudentRecords,
    ending: (String) -> String,
) {
    get("/students/{student}/export") {
        val instructor = call.instructor()
        val asked = call.request.queryParameters["as"] ?: JSON
        if (asked !in setOf(JSON, ZIP)) throw Rejection.Malformed("as is '$asked', allowed are $JSON, $ZIP")
        val kept = records.export(call.parameters.getOrFail("student"), instructor.id)
        if (asked == JSON) call.respondJson(kept) else call.respondZip(kept, ending)
    }
    delete("/students/{student}") {
        val instructor = call.instructor()
        val gone = records.delete(call.parameters.getOrFail("student"), instructor.id)
        call.respondJson(DeletedAnswer(gone.student, gone.submissions.size))
    }
}

private const val JSON = "json"
private const val ZIP = "zip"
private val ZIPPED = ContentType.parse("application/zip")

/** Writes the document for people. */
internal val readable = Json { prettyPrint = true }

/**
 * Answers with the document, and each source as a file of its own.
 *
 * @param ending of a source's file, by exercise
 */
suspend fun ApplicationCall.respondZip(
    kept: KeptStudent,
    ending: (String) -> String,
) {
    response.header(HttpHeaders.ContentDisposition, "attachment; filename=\"student-${kept.number}.zip\"")
    respondBytes(zipped(kept, ending), ZIPPED)
}

/**
 * The document, and each source as a file of its own, in a ZIP file.
 *
 * @param ending of a source's file, by exercise
 */
internal fun zipped(
    kept: KeptStudent,
    ending: (String) -> String,
): ByteArray {
    val bytes = ByteArrayOutputStream()
    ZipOutputStream(bytes).use { zip ->
        fun file(
            name: String,
            text: String,
        ) {
            zip.putNextEntry(ZipEntry(name))
            zip.write(text.toByteArray())
            zip.closeEntry()
        }
        file("student.json", readable.encodeToString(kept))
        for (one in kept.submissions) {
            file("${one.exercise}/attempt-${one.attempt}.${ending(one.exercise)}", one.source)
        }
    }
    return bytes.toByteArray()
}
