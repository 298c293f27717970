package rasterlab.grader.submission

import io.ktor.client.request.forms.FormPart
import io.ktor.client.request.forms.MultiPartFormDataContent
import io.ktor.client.request.forms.formData
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.http.headersOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments
import org.junit.jupiter.params.provider.Arguments.argumentSet
import org.junit.jupiter.params.provider.MethodSource
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.query
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPOutputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.streams.toList

/** Attacks by what is uploaded: an archive is no source, and a file's name names nothing here. */
@Tag("slow")
class UploadAttacksTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest(name = "the name of an uploaded file is \"{0}\"")
    @ValueSource(
        strings = [
            "@/etc/passwd", "-version", "../../../etc/cron.d/x.java", "/etc/passwd", "CON.java", "Mine.java\u0000.txt",
            "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA.java",
        ],
    )
    fun aFileNameNamesNothing(name: String) =
        Classroom(folder).run {
            open(grades = false) {
                val student = newStudent()
                val before = files()
                val disposition = "filename=\"${name.replace("\u0000", "%00")}\""
                val part = FormPart("source", "class Form {}", headersOf(HttpHeaders.ContentDisposition, disposition))
                val answer =
                    client.post(SUBMISSIONS) {
                        bearer(student)
                        setBody(MultiPartFormDataContent(formData(part)))
                    }
                assertEquals(202, answer.status.value, answer.bodyAsText())
                assertEquals("class Form {}", query(file, "SELECT source FROM submissions"))
                assertEquals(before, files(), "a file was written")
            }
        }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("archives")
    fun anArchiveIsNoSource(
        body: ByteArray,
        type: String,
        status: Int,
        problem: String,
    ) = Classroom(folder).run {
        open(grades = false) {
            val student = newStudent()
            val before = files()
            send(student, body, type).assertProblem(status, problem)
            assertEquals("0", query(file, "SELECT count(*) FROM submissions"))
            assertEquals(before, files(), "a file was written")
        }
    }

    @Test
    @DisplayName("a body that is said to be packed is unpacked without a limit")
    fun aPackedBodyIsNotUnpacked() =
        Classroom(folder).run {
            open(grades = false) {
                val answer =
                    send(newStudent(), packed(50_000_000), "text/x-java-source") {
                        header(HttpHeaders.ContentEncoding, "gzip")
                    }
                assertEquals("0", query(file, "SELECT count(*) FROM submissions"))
                assertEquals(4, answer.status.value / 100, answer.bodyAsText())
            }
        }

    private suspend fun Visit.send(
        student: String,
        body: ByteArray,
        type: String,
        more: io.ktor.client.request.HttpRequestBuilder.() -> Unit = {},
    ): HttpResponse =
        client.post(SUBMISSIONS) {
            bearer(student)
            header(HttpHeaders.ContentType, type)
            more()
            setBody(body)
        }

    private fun files(): List<String> = Files.walk(folder).use { all -> all.map { "$it" }.toList() }.sorted()

    companion object {
        private const val SUBMISSIONS = "/api/v1/exercises/draw-dot/submissions"
        private const val SOURCE = "text/x-java-source"

        @JvmStatic
        fun archives(): List<Arguments> =
            listOf(
                argumentSet("leads out of the folder", zip("../../evil.java", 10), SOURCE, 422, "not-utf-8"),
                argumentSet("has an absolute path", zip("/etc/cron.d/evil", 10), SOURCE, 422, "not-utf-8"),
                argumentSet("is a bomb", zip("Mine.java", 50_000_000), SOURCE, 422, "not-utf-8"),
                argumentSet("is called an archive", zip("Mine.java", 10), "application/zip", 415, "wrong-media-type"),
                argumentSet("is a packed source", packed(10_000_000), SOURCE, 422, "not-utf-8"),
            )

        private fun zip(
            name: String,
            size: Int,
        ): ByteArray {
            val bytes = ByteArrayOutputStream()
            ZipOutputStream(bytes).use { zip ->
                zip.putNextEntry(ZipEntry(name))
                zip.write(ByteArray(size) { 'a'.code.toByte() })
            }
            return bytes.toByteArray()
        }

        private fun packed(size: Int): ByteArray {
            val bytes = ByteArrayOutputStream()
            GZIPOutputStream(bytes).use { it.write(ByteArray(size) { 'a'.code.toByte() }) }
            return bytes.toByteArray()
        }
    }
}
