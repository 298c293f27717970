package rasterlab.grader.storage

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import org.sqlite.SQLiteConfig
import org.sqlite.SQLiteDataSource
import rasterlab.grader.postgres.LocalPostgres
import rasterlab.grader.submission.Submissions
import java.nio.file.Path
import javax.sql.DataSource

/** Tables with the data of each version that servers had are brought to this one, in both databases alike. */
@Tag("slow")
class TablesTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest(name = "a course of version {0} is lost, or cannot be told from another")
    @ValueSource(ints = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11])
    fun keepsACourseOfEachVersion(version: Int) {
        val sqlite = sqlite()
        Tables(sqlite).migrate("$version")
        fill(sqlite, version)
        Tables(sqlite).migrate()
        assertWhole(sqlite, version)
    }

    @Test
    @DisplayName("PostgreSQL's tables lack what SQLite's have, or a course of its first version is lost")
    fun bothDatabasesHaveTheSameTables() =
        LocalPostgres().use { postgres ->
            Tables(postgres.source).migrate("11")
            fill(postgres.source, 11)
            Tables(postgres.source).migrate()
            assertWhole(postgres.source, 11)
            val sqlite = sqlite()
            Tables(sqlite).migrate()
            assertEquals(columns(sqlite), columns(postgres.source))
        }

    @Test
    @DisplayName(
        "who taught before is shut out, what was noted of them is lost, or only what belongs to a course is noted",
    )
    fun keepsStaffAndWhatTheyDid() =
        LocalPostgres().use { postgres ->
            for (source in listOf(sqlite(), postgres.source)) {
                Tables(source).migrate("13")
                source.execute(
                    "INSERT INTO courses (id, name, code, created_at) VALUES ('c', 'Graphics', 'CODE', '$THEN')",
                )
                source.execute("INSERT INTO instructors (id, token_hash, created_at) VALUES ('i', 'hash', '$THEN')")
                source.execute("INSERT INTO audit VALUES ('n', '$THEN', 'i', 'c', 'rules', 'draw-dot', 'more')")
                Tables(source).migrate()
                source.assertRows("id, name, role, revoked_at FROM instructors", "i  instructor null")
                source.assertRows("* FROM audit", "n $THEN i c rules draw-dot more")
                source.execute("INSERT INTO audit VALUES ('m', '$THEN', 'i', NULL, 'staff-add', 'j', '')")
                source.assertRows("course_id FROM audit", "c", "null")
            }
        }

    @Test
    @DisplayName("a course of version 13 or 14 is lost in one of the databases, or its results take no points by hand")
    fun gradesAgainWhatWasThereBefore() =
        LocalPostgres().use { postgres ->
            for (source in listOf(sqlite(), postgres.source)) {
                Tables(source).migrate("11")
                fill(source, 11)
                Tables(source).migrate("13")
                Tables(source).migrate("14")
                source.execute(
                    """INSERT INTO regrades (id, course_id, exercise, revision, choice, is_dry, state, account_id, begun_at)
                       VALUES ('g', 'c', 'draw-dot', 'r1', 'all', 1, 'grading', 'i', '$THEN')""",
                )
                source.execute(
                    """INSERT INTO regrade_items (regrade_id, submission_id, position, state, result_id)
                       SELECT 'g', submission_id, run, 'done', id FROM results WHERE is_current = 1""",
                )
                source.assertRows(
                    "choice, r.run FROM regrades JOIN regrade_items ON regrade_id = 'g' JOIN results r ON r.id = result_id",
                    "all 2",
                )
                Tables(source).migrate()
                assertWhole(source, 11)
                source.assertRows("count(*) FROM regrade_items WHERE result_id IS NOT NULL", "1")
                source.execute(
                    """INSERT INTO adjustments (id, submission_id, points, reason, total_before, account_id, given_at)
                       VALUES ('p', 's', -2, 'why', 9, 'i', '$THEN')""",
                )
                source.assertRows("${Submissions.NET} FROM submissions s JOIN results r ON r.run = 2", "7")
            }
        }

    @Test
    @DisplayName("a comment of version 16 is lost or waits for an answer, or none of its lines can be answered")
    fun keepsWhatWasSaidBefore() =
        LocalPostgres().use { postgres ->
            for (source in listOf(sqlite(), postgres.source)) {
                Tables(source).migrate("11")
                fill(source, 11)
                Tables(source).migrate("16")
                source.execute("INSERT INTO comments VALUES ('k', 's', 3, 'i', 'why?', '$THEN')")
                source.execute("INSERT INTO comments VALUES ('l', 's', NULL, 'i', 'fine', '$THEN')")
                Tables(source).migrate()
                assertWhole(source, 11)
                source.assertRows(
                    "id, line, last_line, thread_id, author_id, text, is_open, edited_at FROM comments",
                    "k 3 3 null i why? 0 null",
                    "l null null null i fine 0 null",
                )
                source.execute(
                    """INSERT INTO comments (id, submission_id, author_id, text, written_at, thread_id)
                       VALUES ('m', 's', 'a', 'so', '$THEN', 'k')""",
                )
                source.execute("INSERT INTO kept_comments VALUES ('q', 'c', 'names', 'Say it.', 'i', '$THEN')")
            }
        }

    @Test
    @DisplayName("what a course of version 16 ruled is lost, or its late work costs something at once")
    fun chargesNothingForWhatCameBefore() =
        LocalPostgres().use { postgres ->
            for (source in listOf(sqlite(), postgres.source)) {
                Tables(source).migrate("11")
                fill(source, 11)
                Tables(source).migrate("16")
                source.execute("UPDATE course_exercises SET late_days = 2, attempts = 3, policy = 'last'")
                Tables(source).migrate()
                assertWhole(source, 11, attempts = "3", policy = "last")
                source.assertRows("late_days, late_penalty FROM course_exercises", "2 0")
                source.assertRows("penalty_agreed, penalty FROM submissions", "0 0")
                source.execute("UPDATE submissions SET penalty = 30")
                source.assertRows("${Submissions.NET} FROM submissions s JOIN results r ON r.run = 2", "7")
            }
        }

    @Test
    @DisplayName("a course of version 18 is lost in one of the databases, or takes no exam")
    fun takesExamsWhereThereWereNone() =
        LocalPostgres().use { postgres ->
            for (source in listOf(sqlite(), postgres.source)) {
                Tables(source).migrate("11")
                fill(source, 11)
                Tables(source).migrate("18")
                source.execute("UPDATE submissions SET penalty = 30, penalty_agreed = 30")
                source.execute("INSERT INTO kept_comments VALUES ('q', 'c', 'names', 'Say it.', 'i', '$THEN')")
                Tables(source).migrate()
                assertWhole(source, 11)
                source.assertRows("penalty, penalty_agreed FROM submissions", "30 30")
                source.assertRows("name FROM kept_comments", "names")
                source.assertRows("count(*) FROM exams", "0")
                source.execute(
                    "INSERT INTO exams VALUES ('e', 'c', 'Midterm', '$THEN', '$THEN', 'UTC', 90, 0, 30, '', 0)",
                )
                source.execute("INSERT INTO exam_exercises VALUES ('e', 'draw-dot', 0)")
                source.execute("INSERT INTO exam_sittings (exam_id, student_id) VALUES ('e', 'a')")
                source.assertRows("student_id, extra, started_at FROM exam_sittings", "a 0 null")
            }
        }

    @Test
    @DisplayName(
        "a course of version 20 is lost in one of the databases, takes no complaint, or names students on charts",
    )
    fun takesComplaintsWhereThereWereNone() =
        LocalPostgres().use { postgres ->
            for (source in listOf(sqlite(), postgres.source)) {
                Tables(source).migrate("11")
                fill(source, 11)
                Tables(source).migrate("20")
                source.execute("INSERT INTO kept_comments VALUES ('q', 'c', 'names', 'Say it.', 'i', '$THEN')")
                Tables(source).migrate()
                assertWhole(source, 11)
                source.assertRows("name FROM kept_comments", "names")
                source.assertRows("id, named_on_front FROM students", "a 0", "b 0", "d 0")
                source.assertRows("count(*) FROM complaints", "0")
                source.execute(
                    """INSERT INTO complaints (id, submission_id, result_id, case_name, text, opened_at)
                       SELECT 'k', submission_id, id, 'case of r1', 'why?', '$THEN' FROM results WHERE is_current = 1""",
                )
                source.assertRows("state, answer, regrade_id FROM complaints", "open null null")
            }
        }

    @Test
    @DisplayName("a course of version 21 is lost in one of the databases, is no platform's, or has but some exercises")
    fun takesPlatformsAndAChoiceOfExercises() =
        LocalPostgres().use { postgres ->
            for (source in listOf(sqlite(), postgres.source)) {
                Tables(source).migrate("11")
                fill(source, 11)
                Tables(source).migrate("21")
                Tables(source).migrate()
                assertWhole(source, 11)
                source.assertRows("count(*) FROM chosen_exercises", "0")
                source.execute("INSERT INTO chosen_exercises VALUES ('c', 'draw-dot')")
                source.execute(
                    """INSERT INTO lti_platforms (id, name, issuer, client_id, deployment, login_url, token_url, keys_url,
                           makes_staff, added_at)
                       VALUES ('p', 'Moodle', 'i', 'r', '1', 'l', 't', 'k', 0, '$THEN')""",
                )
                source.execute("INSERT INTO lti_contexts VALUES ('p', 'x', 'CG', 'c', '$THEN')")
                source.execute("INSERT INTO lti_students VALUES ('p', 'sub', 'c', 'a', 'Ada')")
                source.assertRows("student_id, title FROM lti_students JOIN lti_contexts ON context = 'x'", "a CG")
            }
        }

    @Test
    @DisplayName("a course of version 23 is lost in one of the databases, or none of its submissions can be copied")
    fun takesCopiesWhereThereWereNone() =
        LocalPostgres().use { postgres ->
            for (source in listOf(sqlite(), postgres.source)) {
                Tables(source).migrate("11")
                fill(source, 11)
                Tables(source).migrate("23")
                source.execute(
                    """INSERT INTO complaints (id, submission_id, result_id, case_name, text, opened_at)
                       SELECT 'k', submission_id, id, 'case of r1', 'why?', '$THEN' FROM results WHERE is_current = 1""",
                )
                source.execute("UPDATE students SET named_on_front = 1 WHERE id = 'b'")
                Tables(source).migrate()
                assertWhole(source, 11)
                source.assertRows("case_name, text FROM complaints", "case of r1 why?")
                source.assertRows("id FROM students WHERE named_on_front = 1", "b")
                source.execute(
                    """INSERT INTO trials (id, submission_id, account_id, revision, source, begun_at)
                       VALUES ('t', 's', 'i', 'r1', 'class Dot {}', '$THEN')""",
                )
                source.assertRows("state, result_id FROM trials", "queued null")
            }
        }

    @Test
    @DisplayName("a course of version 27 is lost in one of the databases, or its staff teach but one")
    fun keepsPicturesThatHadNoHash() =
        LocalPostgres().use { postgres ->
            for (source in listOf(sqlite(), postgres.source)) {
                Tables(source).migrate("11")
                fill(source, 11)
                Tables(source).migrate("27")
                source.execute("INSERT INTO group_comments VALUES ('c', 'draw-dot', 'g', 'Look.', 'i', '$THEN')")
                source.execute("INSERT INTO instructors (id, token_hash, created_at) VALUES ('i', 'hash', '$THEN')")
                Tables(source).migrate()
                assertWhole(source, 11)
                source.assertRows("id, course_id FROM instructors", "i null")
                source.assertRows("wrong_group, text FROM group_comments", "g Look.")
                source.assertRows("png_hash FROM case_pictures", "null")
                source.execute("UPDATE case_pictures SET png_hash = 'h'")
                source.assertRows("kind, png_hash FROM case_pictures", "actual h")
            }
        }

    private fun sqlite(): DataSource =
        SQLiteDataSource(SQLiteConfig().apply { enforceForeignKeys(true) })
            .apply { url = "jdbc:sqlite:${folder.resolve("course.db")}" }

    /** Three students, of whom two have one name; one submission, graded against two revisions. */
    private fun fill(
        source: DataSource,
        version: Int,
    ) {
        source.execute("INSERT INTO courses (id, name, code, created_at) VALUES ('c', 'Graphics', 'CODE', '$THEN')")
        for ((id, name) in listOf("a" to "Ada", "b" to "Ada", "d" to "Ada (2)")) {
            source.execute(
                """INSERT INTO students (id, course_id, name, token_hash, joined_at)
                   VALUES ('$id', 'c', '$name', 'hash of $id', '$THEN')""",
            )
        }
        source.execute(
            """INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state)
               VALUES ('s', 'a', 'draw-dot', 'r0', 1, 'class Dot {}', 1, '$THEN', 'done')""",
        )
        // The one that counts is stored first, so that its place among the rows says nothing.
        for ((revision, points) in listOf("r1" to 6, "r0" to 4)) {
            source.execute(
                """INSERT INTO results (submission_id, revision, verdict, accuracy, stability, speed, points_of, isolation,
                       nanos_per_item, graded_at)
                   VALUES ('s', '$revision', 'wrong', $points, 2, 1, 10, 'bubblewrap', 2.5, '2026-04-0${revision[1]}')""",
            )
            source.execute(
                """INSERT INTO case_results (submission_id, revision, position, name, visibility, verdict, points, points_of,
                       message, scene)
                   VALUES ('s', '$revision', 0, 'case of $revision', 'OPEN', 'WRONG', 0, 1, 'pixel', '')""",
            )
            source.execute(
                """INSERT INTO diagnostics (submission_id, revision, position, line, column_number, message)
                   VALUES ('s', '$revision', 0, 3, 4, 'of $revision')""",
            )
        }
        if (version >= 7) {
            source.execute(
                """INSERT INTO case_pictures (submission_id, revision, case_position, position, kind, png, text, text_data)
                   VALUES ('s', 'r1', 0, 0, 'actual', ${bytes(source, "01")}, '#', '[]')""",
            )
        }
        if (version >= 9) source.execute("INSERT INTO deadlines VALUES ('c', 'draw-dot', '$THEN')")
        if (version >= 10) {
            source.execute("UPDATE results SET reference_nanos = 5, error = 0.5 WHERE revision = 'r1'")
            source.execute("INSERT INTO speed_methods VALUES ('s', 'r1', 0, 'dda', 1.5, NULL)")
        }
        if (version >= 11) source.execute("UPDATE case_pictures SET png_ru = ${bytes(source, "02")}")
    }

    private fun bytes(
        source: DataSource,
        hex: String,
    ) = if (source is SQLiteDataSource) "x'$hex'" else "'\\x$hex'"

    private fun assertWhole(
        source: DataSource,
        version: Int,
        attempts: String = "null",
        policy: String = "best",
    ) {
        val figures = if (version >= 10) "5.0 0.5" else "null null"
        source.assertRows("run, is_current, revision, accuracy FROM results", "1 0 r0 4", "2 1 r1 6")
        source.assertRows("nanos_per_item, reference_nanos, error FROM results WHERE run = 2", "2.5 $figures")
        val run = "run FROM results JOIN"
        source.assertRows("name, $run case_results ON result_id = results.id", "case of r0 1", "case of r1 2")
        source.assertRows("message, line, $run diagnostics ON result_id = results.id", "of r0 3 1", "of r1 3 2")
        val kept = { first: Int, row: String -> if (version >= first) arrayOf(row) else emptyArray() }
        source.assertRows("kind, text, $run case_pictures ON result_id = results.id", *kept(7, "actual # 2"))
        val russian = if (version >= 11) "1" else "null"
        source.assertRows("length(png), length(png_ru) FROM case_pictures", *kept(7, "1 $russian"))
        source.assertRows("method, ratio, $run speed_methods ON result_id = results.id", *kept(10, "dda 1.5 2"))
        source.assertRows(
            "due_at, zone, policy, attempts FROM course_exercises",
            *kept(9, "$THEN UTC $policy $attempts"),
        )
        source.assertRows("number, shown_name FROM students", "1 Ada", "2 Ada (2)", "3 Ada (2) (3)")
        source.assertRows("is_chosen, hint_cost FROM submissions", "0 0")
    }

    /** Rows in the order of their text. */
    private fun DataSource.assertRows(
        query: String,
        vararg expected: String,
    ) = assertEquals(expected.toList(), rows("SELECT $query"), query)

    private fun DataSource.rows(query: String): List<String> =
        connection.use { connection ->
            connection.createStatement().use { statement ->
                statement.executeQuery(query).use { row ->
                    val width = row.metaData.columnCount
                    generateSequence {
                        if (row.next()) {
                            (1..width).joinToString(
                                " ",
                            ) { "${row.getObject(it)}" }
                        } else {
                            null
                        }
                    }.toList()
                        .sorted()
                }
            }
        }

    private fun DataSource.execute(sql: String) =
        connection.use { connection -> connection.createStatement().use { it.execute(sql) } }

    /** Names of all columns, of ours only. */
    private fun columns(source: DataSource): List<String> =
        source.connection.use { connection ->
            connection.metaData.getColumns(null, null, null, null).use { row ->
                val others = setOf("information_schema", "pg_catalog")
                generateSequence {
                    if (row.next()) listOf("TABLE_SCHEM", "TABLE_NAME", "COLUMN_NAME").map(row::getString) else null
                }.filter { it[0] !in others && !it[1].startsWith("flyway") && !it[1].startsWith("sqlite_") }
                    .filter { it[1] in tables(source) }
                    .map { "${it[1]}.${it[2]}" }
                    .toList()
                    .sorted()
            }
        }

    private fun tables(source: DataSource): Set<String> =
        source.connection.use { connection ->
            connection.metaData.getTables(null, null, null, arrayOf("TABLE")).use { row ->
                generateSequence { if (row.next()) row.getString("TABLE_NAME") else null }.toSet()
            }
        }

    private companion object {
        const val THEN = "2026-03-29T00:59:59.000Z"
    }
}
