package rasterlab.grader.storage

import org.junit.jupiter.api.AfterAll
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource
import org.sqlite.SQLiteConfig
import org.sqlite.SQLiteDataSource
import rasterlab.grader.postgres.LocalPostgres
import rasterlab.grader.submission.Reports
import rasterlab.grader.submission.Submissions
import java.nio.file.Path
import java.sql.ResultSet
import javax.sql.DataSource
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * A course with something in each of its tables, as a server of each version left it, is brought to this version.
 * The versions before the twelfth, whose tables were others, have tests of their own.
 */
@Tag("slow")
class EachVersionTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest(name = "what tables of version {0} held is lost, or changed in one of the databases")
    @MethodSource("versions")
    fun keepsEachRow(version: String) =
        onBoth { source ->
            source.fillUpTo(version)
            val before = source.tables().associateWith { source.columns(it) }
            val held = before.mapValues { (table, columns) -> source.rows(table, columns) }
            Tables(source).migrate()
            for ((table, columns) in before) assertEquals(held[table], source.rows(table, columns), table)
        }

    @Test
    @DisplayName("a table has no row to be kept, so that nobody would see it lost")
    fun fillsEachTable() =
        onBoth { source ->
            source.fillUpTo(versions().last())
            assertEquals(emptyList<String>(), source.tables().filter { source.rows(it, source.columns(it)).isEmpty() })
        }

    @Test
    @DisplayName(
        "a line that was commented has no last line, one that was queued begins no turns, or a number is given twice",
    )
    fun fillsWhatIsNew() =
        onBoth { source ->
            source.fillUpTo("16")
            Tables(source).migrate()
            assertEquals(listOf("3 3"), source.query("SELECT line, last_line FROM comments"))
            assertEquals(listOf("s 1", "t 0", "u 1"), source.query("SELECT id, begins_turns FROM submissions"))
            assertEquals(listOf("c 2"), source.query("SELECT id, last_number FROM courses"))
        }

    @ParameterizedTest(name = "a server that opens a course of version {0} reads other points or another report")
    @MethodSource("versions")
    fun isReadAsBefore(version: String) {
        val file = folder.resolve("course.db")
        sqlite().fillUpTo(version)
        Database.open(file).use { database ->
            val penalized = if (version.toDouble() < 18) 0 else 20
            val taken = if (version.toDouble() < 15) 0 else 2
            assertEquals(penalized, Submissions(database).find("u")?.penalty)
            assertEquals(mapOf("draw-dot" to 8 - 1 - taken), Submissions(database).bests("a"))
            val report = checkNotNull(Reports(database).of("s")).report
            assertEquals(listOf("steep"), report.cases().map { it.name() })
            assertEquals(
                1,
                report
                    .cases()
                    .single()
                    .pictures()
                    .size,
            )
        }
    }

    private fun onBoth(check: (DataSource) -> Unit) {
        check(sqlite())
        val name = "course${folder.name.hashCode()}"
        postgres.value.address(name)
        check(postgres.value.source(name))
    }

    private fun sqlite(): DataSource =
        SQLiteDataSource(SQLiteConfig().apply { enforceForeignKeys(true) })
            .apply { url = "jdbc:sqlite:${folder.resolve("course.db")}" }

    /** Brings tables from version to version, as a server that was upgraded each time, and fills in what each took first. */
    private fun DataSource.fillUpTo(version: String) {
        Tables(this).migrate("11")
        val rows =
            ROWS.split("-- since ").drop(1).associate {
                it.substringBefore('\n').trim() to
                    it.substringAfter('\n')
            }
        for ((since, statements) in rows) {
            if (since.toDouble() > version.toDouble()) break
            Tables(this).migrate(since)
            statements.split(";\n").filter(String::isNotBlank).forEach { execute(withBytes(it)) }
        }
        Tables(this).migrate(version)
    }

    private fun DataSource.withBytes(statement: String) =
        BYTES.replace(
            statement,
        ) { if (this is SQLiteDataSource) "x'${it.groupValues[1]}'" else "'\\x${it.groupValues[1]}'" }

    private fun DataSource.tables(): List<String> =
        connection.use { connection ->
            connection.metaData.getTables(null, null, "%", arrayOf("TABLE")).use { row ->
                row
                    .all { it.getString("TABLE_NAME") }
                    .filter { !it.startsWith("flyway") && !it.startsWith("sqlite") && it != "scheduled_tasks" }
                    .sorted()
            }
        }

    private fun DataSource.columns(table: String): List<String> =
        connection.use { connection ->
            connection.metaData.getColumns(null, null, table, "%").use { row ->
                row.all { it.getString("COLUMN_NAME") }
            }
        }

    private fun DataSource.rows(
        table: String,
        columns: List<String>,
    ) = query("SELECT ${columns.joinToString()} FROM $table")

    /** Rows in the order of their text. */
    private fun DataSource.query(sql: String): List<String> =
        connection.use { connection ->
            connection.createStatement().use { statement ->
                statement.executeQuery(sql).use { row ->
                    row
                        .all { one ->
                            (1..one.metaData.columnCount).joinToString(" ") { text(one.getObject(it)) }
                        }.sorted()
                }
            }
        }

    private fun text(value: Any?) = if (value is ByteArray) value.toList().toString() else "$value"

    private fun <T> ResultSet.all(one: (ResultSet) -> T): List<T> =
        generateSequence { if (next()) Result.success(one(this)) else null }.map { it.getOrThrow() }.toList()

    private fun DataSource.execute(sql: String) =
        connection.use { connection -> connection.createStatement().use { it.execute(sql) } }

    private companion object {
        val BYTES = Regex("""\$\{bytes:([0-9a-f]+)}""")
        val ROWS = checkNotNull(EachVersionTest::class.java.getResource("rows.sql")).readText()

        /** One server for all tests, each of which has a database of its own there. */
        val postgres = lazy { LocalPostgres() }

        @JvmStatic
        @AfterAll
        fun stopPostgres() {
            if (postgres.isInitialized()) postgres.value.close()
        }

        /** Lists the versions whose scripts both databases share, from the twelfth on. */
        @JvmStatic
        fun versions(): List<String> {
            val first = checkNotNull(Tables::class.java.getResource("shared/V12__course_life.sql"))
            return Path
                .of(first.toURI())
                .parent
                .listDirectoryEntries("V*.sql")
                .map { it.name.removePrefix("V").substringBefore("__") }
                .sortedBy { it.toDouble() }
        }
    }
}
