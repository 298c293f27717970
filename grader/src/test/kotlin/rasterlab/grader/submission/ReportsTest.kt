package rasterlab.grader.submission

import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import rasterlab.engine.raster.Pixel
import rasterlab.engine.raster.PixelWindow
import rasterlab.engine.study.measuring.MedianInterval
import rasterlab.exercises.score.CasePicture
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Diagnostic
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Message
import rasterlab.exercises.score.PictureBytes
import rasterlab.exercises.score.PicturePart
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.exercises.score.SpeedFigures
import rasterlab.grader.Classroom
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.limits.IntakeLimits
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.storage.Database
import java.nio.file.Path
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import java.util.Optional
import java.util.function.Supplier

/** A report comes back as it was written; no two values are equal, so a column taken for another is seen. */
@Tag("slow")
open class ReportsTest {
    @TempDir
    lateinit var folder: Path
    private lateinit var database: Database
    private val now = Instant.parse("2026-03-29T00:59:59.123Z")
    private val clock = InstantSource { now }

    @BeforeEach
    fun open() {
        database = TestDatabases.open(folder)
    }

    @AfterEach
    fun close() = database.close()

    @ParameterizedTest(name = "the verdict {0} is not read back")
    @EnumSource
    fun keepsTheWhole(verdict: GradingVerdict) {
        val written = Report(verdict, ScorePoints(11, 7, 3, 23), emptyList(), emptyList(), "bubblewrap «ящик»", 12.625)
        val found = recorded(written)
        assertEquals(verdict, found.report.verdict())
        assertEquals(written.points(), found.report.points())
        assertEquals(written.isolation(), found.report.isolation())
        assertEquals(written.nanosPerItem(), found.report.nanosPerItem())
        assertEquals(now, found.gradedAt)
    }

    @Test
    fun keepsTheFiguresOfItsSpeed() {
        val dda = SpeedFigures.MethodSpeed("dda", MedianInterval(2.25, 2.5, 2.875), 0.125)
        val methods = listOf(dda, SpeedFigures.MethodSpeed("wu", 4.25, INFINITE))
        for (error in listOf(0.0, 0.75, INFINITE)) {
            val figures = SpeedFigures(MedianInterval(3.125, 12.625 / 3.5, 4.75), 3.5, error, methods)
            val written = Report(GradingVerdict.OK, ScorePoints(0, 0, 1, 1), emptyList(), emptyList(), "", 12.625)
            assertEquals(Optional.of(figures), recorded(written.with(Optional.of(figures))).report.figures())
        }
        assertEquals(Optional.empty<SpeedFigures>(), recorded(report()).report.figures())
    }

    @Test
    @DisplayName("what was measured before intervals were kept cannot be read")
    fun readsFiguresWithoutIntervals() {
        val methods = listOf(SpeedFigures.MethodSpeed("dda", MedianInterval(2.25, 2.5, 2.875), 0.125))
        val figures = SpeedFigures(MedianInterval(3.125, 12.625 / 3.5, 4.75), 3.5, 0.0, methods)
        val written = Report(GradingVerdict.OK, ScorePoints(0, 0, 1, 1), emptyList(), emptyList(), "", 12.625)
        recorded(written.with(Optional.of(figures)))
        for (table in listOf("results", "speed_methods")) {
            database.write { it.execute("UPDATE $table SET ratio_low = NULL, ratio_high = NULL") }
        }
        val id = database.read { it.createQuery("SELECT id FROM submissions").mapTo(String::class.java).one() }
        val exact = SpeedFigures(12.625, 3.5, 0.0, listOf(SpeedFigures.MethodSpeed("dda", 2.5, 0.125)))
        assertEquals(Optional.of(exact), Reports(database).of(id)?.report?.figures())
    }

    @Test
    fun keepsEachCaseInItsPlace() {
        val written =
            GradingVerdict.entries.mapIndexed { number, verdict ->
                CaseReport(
                    "case-${9 - number}",
                    Disclosure.entries[number % Disclosure.entries.size],
                    verdict,
                    number,
                    100 + number,
                    Message.quoted("pixel ($number, −1) is missing, значение"),
                    pictures(number),
                    """{"from":[$number,0]}""",
                )
            }
        val found = recorded(report(cases = written)).report.cases()
        assertEquals(written.map(::columns), found.map(::columns))
    }

    @Test
    fun keepsEachDiagnosticInItsPlace() {
        val written =
            listOf(
                Diagnostic(17, 4, Message.quoted("';' expected")),
                Diagnostic(3, 29, Message.quoted("нет символа")),
                Diagnostic(0, 0, Message.NONE),
            )
        assertEquals(written, recorded(report(diagnostics = written)).report.diagnostics())
    }

    @Test
    @DisplayName("grading again overwrites what was found before, or what counts is the one with the later time")
    fun anotherRunIsAddedAndCounts() {
        val reports = Reports(database)
        val id = submission()
        val runs = List(3) { Report(GradingVerdict.WRONG, ScorePoints(it, 0, 0, 9), emptyList(), emptyList(), "", 0.0) }
        for ((number, run) in runs.withIndex()) {
            // The clock is set back between them.
            database.write { reports.insert(it, id, "r1", run, now - Duration.ofHours(number.toLong())) }
        }
        assertEquals(
            2,
            reports
                .of(id)
                ?.report
                ?.points()
                ?.accuracy(),
        )
        assertEquals(mapOf("draw-dot" to 2), Submissions(database).bests(student(id)))
        val kept =
            database.read { handle ->
                handle
                    .createQuery("SELECT run || ' ' || accuracy || ' ' || is_current FROM results ORDER BY run")
                    .mapTo(String::class.java)
                    .list()
            }
        assertEquals(listOf("1 0 0", "2 1 0", "3 2 1"), kept)
    }

    private fun student(submission: String) = checkNotNull(Submissions(database).find(submission)).student

    private fun pictures(number: Int) =
        listOf("difference", "input", "actual").take(number % 4).mapIndexed { place, kind ->
            if (kind == "input") {
                val file = PictureBytes.of(png(number, place), mapOf("ru" to Supplier { png(number, place + 7) }))
                CasePicture(kind, file, Message.of("pixel.missing", "($number, 1)"), Optional.empty())
            } else {
                CasePicture(kind, png(number, place), Message.rows("#+-.$number$place"), Optional.of(part(number)))
            }
        }

    private fun part(number: Int) =
        PixelWindow(number, 0, number + 3, 0).let { PicturePart(it, PixelWindow(0, 0, 99, 99), Pixel(number, 0)) }

    private fun png(
        number: Int,
        kind: Int,
    ) = byteArrayOf(number.toByte(), kind.toByte(), 0, -1)

    /** Arrays are equal by their content here. */
    private fun columns(case: CaseReport): List<Any?> {
        val pictures =
            case.pictures().map {
                listOf(
                    it.kind(),
                    it.png().toList(),
                    it.png("ru").toList(),
                    it.text(),
                    it.part(),
                )
            }
        return listOf(
            case.name(),
            case.visibility(),
            case.verdict(),
            case.points(),
            case.of(),
            case.explanation(),
            case.scene(),
            pictures,
        )
    }

    private fun report(
        cases: List<CaseReport> = emptyList(),
        diagnostics: List<Diagnostic> = emptyList(),
    ) = Report(GradingVerdict.WRONG, ScorePoints(0, 0, 0, 0), cases, diagnostics, "", 0.0)

    private fun recorded(report: Report): Recorded {
        val reports = Reports(database)
        val leases = Leases(database, reports, clock, clock)
        val id = submission()
        leases.finish(checkNotNull(leases.claimNext()), "r1", report)
        return checkNotNull(reports.of(id))
    }

    private companion object {
        const val INFINITE = Double.POSITIVE_INFINITY
    }

    private fun submission(): String {
        val courses = Courses(database, clock)
        val course = courses.create(by = "i", Name.of("Graphics"), key = null)
        val token = courses.join(course.code, Name.of("Ada"), key = null).token
        val student = Accounts(database, clock).holder(token) as Identity.StudentIdentity
        return Intake(
            database,
            IntakeLimits(),
            clock,
        ).accept(student, Classroom.EXERCISE, "class Dot {}", key = null).id
    }
}
