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
import java.nio.ByteBuffer
import java.nio.ByteOrder
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

    @ParameterizedTest(name = "an archive {argumentSetName}")
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
                    send(newStudent(), packed(ByteArray(50_000_000) { 'a'.code.toByte() }), SOURCE) {
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

        /** Where the head of a file in the table at the end of an archive has its fields. */
        private const val SYSTEM = 5
        private const val LENGTH = 24
        private const val RIGHTS = 38
        private const val PLACE = 42

        /** The system whose rights those are, and two kinds of files that are none. */
        private const val UNIX = 3
        private const val LINK = 0xA1FF shl 16
        private const val DEVICE = 0x61B6 shl 16

        @JvmStatic
        fun archives(): List<Arguments> =
            listOf(
                argumentSet("leads out of the folder", zip("../../evil.java"), SOURCE, 422, "not-utf-8"),
                argumentSet("has an absolute path", zip("/etc/cron.d/evil"), SOURCE, 422, "not-utf-8"),
                argumentSet("has a symbolic link", unix(zip("link"), LINK), SOURCE, 422, "not-utf-8"),
                argumentSet("has a device", unix(zip("sda"), DEVICE), SOURCE, 422, "not-utf-8"),
                argumentSet("has a hard link", packed(tarOfAHardLink()), SOURCE, 422, "not-utf-8"),
                argumentSet("is a bomb", zip("Mine.java", size = 50_000_000), SOURCE, 422, "not-utf-8"),
                argumentSet(
                    "holds a bomb",
                    zip("inner.zip", content = zip("a", size = 50_000_000)),
                    SOURCE,
                    422,
                    "not-utf-8",
                ),
                argumentSet("tells a false size", changed(zip("a"), LENGTH, Int.MAX_VALUE), SOURCE, 422, "not-utf-8"),
                argumentSet("has files that overlap", changed(zip("a", "b", "c"), PLACE, 0), SOURCE, 422, "not-utf-8"),
                argumentSet("has 100,000 files", zip(*names(100_000), size = 0), SOURCE, 413, "too-large"),
                argumentSet("is called an archive", zip("Mine.java"), "application/zip", 415, "wrong-media-type"),
                argumentSet(
                    "is a packed source",
                    packed(ByteArray(10_000_000) { 'a'.code.toByte() }),
                    SOURCE,
                    422,
                    "not-utf-8",
                ),
            )

        private fun names(count: Int) = Array(count) { "$it" }

        private fun zip(
            vararg names: String,
            size: Int = 10,
            content: ByteArray = ByteArray(size) { 'a'.code.toByte() },
        ): ByteArray {
            val bytes = ByteArrayOutputStream()
            ZipOutputStream(bytes).use { zip ->
                for (name in names) {
                    zip.putNextEntry(ZipEntry(name))
                    zip.write(content)
                }
            }
            return bytes.toByteArray()
        }

        private fun unix(
            zip: ByteArray,
            rights: Int,
        ): ByteArray = changed(zip, RIGHTS, rights).also { for (head in heads(it)) it[head + SYSTEM] = UNIX.toByte() }

        /** An archive with that number in a field of four bytes, for each of its files. */
        private fun changed(
            zip: ByteArray,
            field: Int,
            number: Int,
        ): ByteArray {
            val buffer = ByteBuffer.wrap(zip.clone()).order(ByteOrder.LITTLE_ENDIAN)
            for (head in heads(zip)) buffer.putInt(head + field, number)
            return buffer.array()
        }

        private fun heads(zip: ByteArray): List<Int> {
            val signature = byteArrayOf('P'.code.toByte(), 'K'.code.toByte(), 1, 2).toList()
            return (0..zip.size - signature.size).filter { zip.slice(it until it + signature.size) == signature }
        }

        /** The head of a file that is another name of one outside, as an archive of tar has it. */
        private fun tarOfAHardLink() =
            ByteArray(1_024).also { tar ->
                "link".encodeToByteArray().copyInto(tar)
                "1/etc/passwd".encodeToByteArray().copyInto(tar, 156)
                "ustar".encodeToByteArray().copyInto(tar, 257)
            }

        private fun packed(content: ByteArray): ByteArray {
            val bytes = ByteArrayOutputStream()
            GZIPOutputStream(bytes).use { it.write(content) }
            return bytes.toByteArray()
        }
    }
}
