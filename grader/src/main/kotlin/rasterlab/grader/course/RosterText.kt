package rasterlab.grader.course

import com.fasterxml.jackson.core.JacksonException
import com.fasterxml.jackson.dataformat.csv.CsvMapper
import com.fasterxml.jackson.dataformat.csv.CsvParser
import com.fasterxml.jackson.dataformat.csv.CsvSchema
import rasterlab.exercises.SourceEncoding
import rasterlab.grader.problem.Rejection
import java.nio.ByteBuffer
import java.nio.charset.CharacterCodingException
import java.nio.charset.Charset

/** The cells of a file that a spreadsheet or a course system wrote, in whatever encoding and with whatever separator. */
internal object RosterText {
    private val csv = CsvMapper().enable(CsvParser.Feature.WRAP_AS_ARRAY).enable(CsvParser.Feature.TRIM_SPACES)
    private val WINDOWS_1251 = Charset.forName("windows-1251")
    private const val MARK = '\uFEFF'

    /** Rows of cells, without those that are empty; where a row has a line break in a cell, its number is the row's. */
    fun rows(bytes: ByteArray): List<IndexedValue<List<String>>> {
        val text = decode(bytes).removePrefix("$MARK")
        // Excel says with such a first line what separates its cells.
        val told = Regex("""sep=(.)\R""").matchAt(text, 0)
        val body = if (told == null) text else text.substring(told.value.length)
        val schema = CsvSchema.emptySchema().withColumnSeparator(told?.run { groupValues[1][0] } ?: separator(body))
        val before = if (told == null) 0 else 1
        val read = mutableListOf<List<String>>()
        try {
            csv
                .readerForListOf(String::class.java)
                .with(schema)
                .readValues<List<String>>(body)
                .readAll(read)
        } catch (malformed: JacksonException) {
            throw Rejection.BadRoster("csv", before + read.size + 1)
        }
        return read
            .mapIndexed { index, cells -> IndexedValue(before + index, cells) }
            .filter { (_, cells) -> cells.any { it.isNotBlank() } }
    }

    /** The one of the three that the first line has most of, outside quotes. */
    private fun separator(text: String): Char {
        val head =
            text
                .lineSequence()
                .firstOrNull { it.isNotBlank() }
                .orEmpty()
                .replace(Regex("\"[^\"]*\""), "")
        return listOf(',', ';', '\t').maxBy { one -> head.count { it == one } }
    }

    private fun decode(bytes: ByteArray): String {
        val wide = utf16(bytes)
        if (wide != null) return String(bytes, wide)
        return try {
            Charsets.UTF_8
                .newDecoder()
                .decode(ByteBuffer.wrap(bytes))
                .toString()
        } catch (otherwise: CharacterCodingException) {
            if (SourceEncoding.of(bytes) != SourceEncoding.WINDOWS_1251) throw Rejection.BadRoster("encoding")
            String(bytes, WINDOWS_1251)
        }
    }

    /** UTF-16 of either order, or null: by its mark, or by the upper halves of its letters, which are every second byte. */
    private fun utf16(bytes: ByteArray): Charset? {
        if (bytes.size < 2) return null
        when (bytes[0].toInt() and 0xFF shl 8 or (bytes[1].toInt() and 0xFF)) {
            0xFEFF -> return Charsets.UTF_16BE
            0xFFFE -> return Charsets.UTF_16LE
        }
        val halves = bytes.indices.filter { bytes[it] in 0..8 }
        if (halves.size * 4 < bytes.size) return null
        return if (halves.count { it % 2 == 0 } > halves.size / 2) Charsets.UTF_16BE else Charsets.UTF_16LE
    }
}
