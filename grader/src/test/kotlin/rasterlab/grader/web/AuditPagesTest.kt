package rasterlab.grader.web

import io.ktor.client.request.delete
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.request.put
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.course.AuditNote
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.nio.file.Path
import java.time.Instant

/** The page of what was changed. */
@Tag("slow")
class AuditPagesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a detail is English on the Russian page, or a moment in it is another than the course's zone has")
    fun tellsDetailsInTheLanguageOfThePage() =
        Classroom(folder).open(grades = false) {
            change()
            val page = show("ru")
            assertFalse("отмеченные ниже" in page, page)
            val said =
                listOf(
                    "добавлено: 2, исправлено: 0",
                    "Срок сдачи: – → 2027-03-02 23:59 Europe/Moscow; Часовой пояс: UTC → Europe/Moscow",
                    "Что засчитывается: лучшая попытка → последняя попытка",
                    "сдвиг в\u00a0днях: 7",
                    "Ассистент, Graphics",
                    "Отправок в\u00a0минуту: 7; Одновременно ждут результата: –",
                    "выбранные решения, решений: 1",
                )
            for (one in said) assertTrue(one in page, "$one: $page")
            for (word in listOf("added", "corrected", "deadline", "days", "assistant", "waiting")) {
                assertFalse(Regex("<div>[^<]*\\b$word\\b").containsMatchIn(page), "$word: $page")
            }
        }

    @Test
    @DisplayName("a phone shows a cell without the name of its column")
    fun namesTheColumnInEachCell() =
        Classroom(folder).open(grades = false) {
            change()
            val page = show("en")
            val table = Regex("<div class=\"scroll\" tabindex=\"0\"[^>]*>\\s*<table class=\"students stacked\">")
            assertTrue(table in page, "the page is as wide as its table: $page")
            val columns = listOf("When", "Who", "What", "Whom or what it is about", "Course", "Detail")
            val cells = Regex("<td data-column=\"([^\"]*)\"").findAll(page).map { it.groupValues[1] }.toList()
            val names = Regex("<th scope=\"col\">([^<]*)").findAll(page).map { it.groupValues[1] }.toList()
            assertEquals(columns.size, names.size, page)
            assertEquals(0, cells.size % names.size)
            assertEquals(names, cells.take(names.size))
        }

    @Test
    @DisplayName("who was deleted is a bare id, or has a name still")
    fun tellsThatAStudentWasDeleted() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            newStudent(course)
            val student = newStudent(course)
            val submission = submit(student).json().text("id")
            val id = one("SELECT id FROM students WHERE number = 2")
            client.post("/api/v1/submissions/$submission/comments") {
                bearer(instructor)
                json("""{"text":"Well done"}""")
            }
            client.post("/api/v1/students/$id/token") { bearer(instructor) }
            client.patch("/api/v1/courses/$course/exercises/draw-dot") {
                bearer(instructor)
                json("""{"deadline":"2097-03-02T12:00:00Z"}""")
            }
            client.put("/api/v1/courses/$course/exercises/draw-dot/extensions/$id") {
                bearer(instructor)
                json("""{"deadline":"2098-03-02T12:00:00Z","reason":"ill"}""")
            }
            assertFalse("deleted student" in show("en"))
            client.delete("/api/v1/students/$id") { bearer(instructor) }
            for ((language, gone) in mapOf("en" to "deleted student, No. 2", "ru" to "удалённый студент, №\u00a02")) {
                val page = show(language)
                val cells = Regex("<span title=\"[^\"]*$id\">([^<]*)").findAll(page).map { it.groupValues[1] }
                val exercise = Classroom.EXERCISE.title(language)
                assertEquals(listOf(gone, "$exercise, $gone", gone), cells.toList(), page)
                val work = PageTexts.of(language).say("audit.deleted.submission")
                assertTrue("<span title=\"$submission\">$work" in page, page)
                assertFalse(Regex(">[^<]*($id|$submission)").containsMatchIn(page), page)
            }
        }

    @Test
    @DisplayName("a moment, a line, a case or an exercise is told as it is stored")
    fun tellsWhatIsStoredInWords() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val submission = submit(newStudent(course)).json().text("id")
            val student = one("SELECT id FROM students")
            client.patch("/api/v1/courses/$course/exercises/draw-dot") {
                bearer(instructor)
                json("""{"deadline":"2097-03-02T12:00:00Z"}""")
            }
            client.put("/api/v1/courses/$course/exercises/draw-dot/extensions/$student") {
                bearer(instructor)
                json("""{"deadline":"2098-03-02T15:00:00+03:00","reason":"ill"}""")
            }
            val by = one("SELECT account_id FROM audit WHERE action = 'rules'")
            val id = one("SELECT id FROM courses WHERE code = '$course'")
            val noted =
                listOf(
                    AuditNote(by, id, "comment", submission, "3"),
                    AuditNote(by, id, "comment-edit", submission, "3–5"),
                    AuditNote(by, id, "complaint-accept", submission, "open-case"),
                    AuditNote(by, id, "exercises", id, "draw-dot, gone"),
                )
            database.write { handle -> noted.forEach { it.write(handle, Instant.parse("2027-03-01T12:00:00Z")) } }
            val told =
                mapOf(
                    "en" to listOf("line 3", "lines 3 to 5", "one pixel", "Draw a dot, gone", "Draw a dot"),
                    "ru" to
                        listOf(
                            "строка 3",
                            "строки с\u00a03 по\u00a05",
                            "один пиксель",
                            "Нарисуйте точку, gone",
                            "Нарисуйте точку",
                        ),
                )
            for ((language, all) in told) {
                val page = show(language)
                for (one in all + "2098-03-02 12:00 UTC") assertTrue("<div>$one</div>" in page, "$one: $page")
                assertTrue("${all.last()}, Ada" in page, "whom an extension is for: $page")
                assertFalse(Regex(">[^<]*(open-case|draw-dot|$student)").containsMatchIn(page), page)
            }
        }

    private suspend fun Visit.change() {
        val course = newCourse()
        client.post("/api/v1/courses/$course/roster") {
            bearer(instructor)
            header(HttpHeaders.ContentType, "text/csv")
            setBody("Name\nAda\nGrace\n")
        }
        for (rules in listOf("""{"deadline":"2027-03-02T23:59","zone":"Europe/Moscow"}""", """{"policy":"last"}""")) {
            client.patch("/api/v1/courses/$course/exercises/draw-dot") {
                bearer(instructor)
                json(rules)
            }
        }
        client.post("/api/v1/courses/$course/clone") {
            bearer(instructor)
            json("""{"name":"Next year","days":7}""")
        }
        client.post("/api/v1/staff") {
            bearer(instructor)
            json("""{"name":"Alan","role":"assistant","course":"$course"}""")
        }
        sendForm("/instructor/courses/$course/exercises/draw-dot", "attempts=")
        client.patch("/api/v1/courses/$course/limits") {
            bearer(instructor)
            json("""{"submissionsPerMinute":7}""")
        }
        val by = one("SELECT account_id FROM audit WHERE action = 'limits'")
        val id = one("SELECT id FROM courses WHERE code = '$course'")
        val note = AuditNote(by, id, "regrade", "none", "draw-dot some 1")
        database.write { note.write(it, Instant.parse("2027-03-01T12:00:00Z")) }
    }

    private suspend fun Visit.show(language: String): String {
        val cookie = cookieOf(instructor)
        return client.get("/instructor/audit?lang=$language") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }
}
