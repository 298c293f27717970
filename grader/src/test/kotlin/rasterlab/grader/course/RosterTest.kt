package rasterlab.grader.course

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import rasterlab.grader.problem.Rejection
import java.nio.charset.Charset
import java.util.Locale

/** A roster is read as whoever made it saved it. */
class RosterTest {
    @ParameterizedTest(name = "a roster in {0} with a mark {2} and the separator ''{1}'' is not read")
    @CsvSource(
        "UTF-8, ',', false",
        "UTF-8, ;, true",
        "UTF-16LE, '\t', true",
        "UTF-16BE, ;, true",
        "UTF-16LE, ;, false",
        "UTF-16BE, ',', false",
        "windows-1251, ;, false",
        "windows-1251, '\t', false",
    )
    fun readsEachEncodingAndSeparator(
        encoding: String,
        separator: String,
        mark: Boolean,
    ) {
        val text =
            "Фамилия|Имя|Почта\r\nЛавлейс|Ада|ada@example.org\r\n\"Хоппер, адмирал\"|Грейс|\r\n".replace(
                "|",
                separator,
            )
        val bytes = ((if (mark) "\uFEFF" else "") + text).toByteArray(Charset.forName(encoding))
        val rows = Roster.read(bytes).rows
        assertEquals(listOf("Ада Лавлейс", "Грейс Хоппер, адмирал"), rows.map { it.name.text })
        assertEquals("ada@example.org", rows[0].fields["email"])
        assertEquals(null, rows[1].fields["email"])
    }

    @Test
    @DisplayName("a roster of 5,000 students is refused, or one more is taken")
    fun takesFiveThousandStudents() {
        val roster = { students: Int -> "Name\n" + (1..students).joinToString("") { "Student $it\n" } }
        assertEquals(5_000, Roster.read(roster(5_000).toByteArray()).rows.size)
        assertThrows(Rejection.BadRoster::class.java) { Roster.read(roster(5_001).toByteArray()) }
    }

    @Test
    @DisplayName("Moodle's export is not read, or its marks are taken for something of the students")
    fun readsMoodlesExport() {
        val rows =
            read(
                """"First name",Surname,"ID number",Institution,Department,"Email address","Draw a dot (Real)","Last downloaded"
                  |Ada,Lovelace,0042,,,ada@example.org,7.00,1764288000
                  |Grace,Hopper,,,,grace@example.org,-,1764288000""",
            )
        assertEquals(listOf("Ada Lovelace", "Grace Hopper"), rows.map { it.name.text })
        val names = mapOf("first-name" to "Ada", "last-name" to "Lovelace")
        assertEquals(names + mapOf("id-number" to "0042", "email" to "ada@example.org"), rows[0].fields)
    }

    @Test
    @DisplayName("columns of which nothing is taken are dropped in silence, or empty ones are complained of")
    fun namesTheColumnsThatAreNotUsed() {
        val table = Roster.read("Name,Mark,,,Email\nAda,7,,x,ada@example.org\nGrace,8,,,\n".toByteArray())
        assertEquals(listOf("Mark", "#4"), table.unused)
    }

    @Test
    @DisplayName("Canvas' export is not read, or the line of points and the test student come along")
    fun readsCanvasExport() {
        val rows =
            read(
                """Student,ID,SIS User ID,SIS Login ID,Section,Draw a dot (77)
                  |    Points Possible,,,,,10
                  |"Lovelace, Ada",123,S1,ada,"Graphics, autumn",7
                  |"Student, Test",999,,,Graphics,""",
            )
        assertEquals(listOf("Ada Lovelace"), rows.map { it.name.text })
        assertEquals("Lovelace, Ada", rows[0].fields["canvas-student"])
        assertEquals("Graphics, autumn", rows[0].fields["section"])
        assertEquals(listOf("canvas-id" to "123", "sis-user-id" to "S1", "sis-login-id" to "ada"), rows[0].keys)
    }

    @Test
    @DisplayName("Excel's line that names the separator is taken for the headings")
    fun skipsTheLineThatNamesTheSeparator() {
        assertEquals(listOf("Lovelace, Ada"), read("sep=;\nName;Comment\nLovelace, Ada;a,b,c").map { it.name.text })
    }

    @ParameterizedTest(name = "what is wrong is not said: {1}")
    @CsvSource(
        "'', no students",
        "'Name', no students",
        "'Mark,Comment\n7,x', headings are Mark",
        "'Name,Name\nAda,Ada', two columns",
        "'Name\nAda\nE\u0007ve', line 3",
        "'Name,Email\nAda,a@b\nGrace,A@B', lines 2 and 3",
        "'Name\n\"Ada', cannot be read as CSV",
    )
    fun saysWhatIsWrong(
        roster: String,
        said: String,
    ) {
        val rejection = assertThrows(Rejection.BadRoster::class.java) { Roster.read(roster.toByteArray()) }
        assertTrue(said in rejection.message, rejection.message)
        assertTrue(rejection.said(Locale.forLanguageTag("ru")).any { it in 'а'..'я' })
    }

    @ParameterizedTest(name = "a wrong quotation mark is told without its line, or in a library's words: {0}")
    @CsvSource("'Name\nAda\n\"x\nEve', 3", "'Name\n\"x\"y', 2", "'sep=;\nName\n\"x', 3")
    fun tellsWhereAQuotationMarkIsWrong(
        roster: String,
        line: Int,
    ) {
        val rejection = assertThrows(Rejection.BadRoster::class.java) { Roster.read(roster.toByteArray()) }
        assertTrue("line $line of the roster" in rejection.message, rejection.message)
        val russian = rejection.said(Locale.forLanguageTag("ru"))
        assertTrue("строка $line списка" in russian, russian)
        assertEquals("CSV", russian.filter { it in 'a'..'z' || it in 'A'..'Z' }, russian)
    }

    @Test
    @DisplayName("names in an encoding that nobody knows become wrong letters")
    fun refusesAnUnknownEncoding() {
        val roster = "Name\nMüller\nGödel\n".toByteArray(Charsets.ISO_8859_1)
        val rejection = assertThrows(Rejection.BadRoster::class.java) { Roster.read(roster) }
        assertTrue("UTF-8" in rejection.message, rejection.message)
    }

    private fun read(roster: String) = Roster.read(roster.trimMargin().toByteArray()).rows
}
