package rasterlab.grader.course

import rasterlab.grader.problem.Rejection

/**
 * One student of a roster.
 *
 * @param fields what the roster says besides the name, by [RosterColumn.kind]
 */
internal data class RosterRow(
    val line: Int,
    val name: Name,
    val fields: Map<String, String>,
) {
    /** Tells this student from all others of the course, by the surest first. */
    val keys = RosterColumn.entries.filter { it.names && it.kind in fields }.map { it.kind to fields.getValue(it.kind) }
}

/**
 * A roster as rows.
 *
 * @param unused the headings of the columns that say nothing that is kept, such as marks; "#4" is the fourth, without
 *     one
 */
internal data class RosterTable(
    val rows: List<RosterRow>,
    val unused: List<String>,
)

/** Reads rosters: exports of Moodle and Canvas as they are, and tables with a heading for the name. */
internal object Roster {
    private const val MOST_STUDENTS = 5_000

    /** A row of Canvas' export that is no student. */
    private val NOBODY = setOf("points possible", "student, test", "test student", "")

    /** @throws Rejection.BadRoster with the number of the row that is at fault */
    fun read(bytes: ByteArray): RosterTable {
        val table = RosterText.rows(bytes)
        if (table.isEmpty()) throw Rejection.BadRoster("empty")
        val columns = table.first().value.map(RosterColumn::headed)
        if (columns.none { it in NAMING }) throw Rejection.BadRoster("headings", table.first().value.joinToString())
        columns.filterNotNull().groupBy { it }.values.firstOrNull { it.size > 1 }?.let {
            throw Rejection.BadRoster("twice", table.first().value[columns.lastIndexOf(it.first())])
        }
        val rows = table.drop(1).mapNotNull { (index, cells) -> row(index + 1, columns, cells) }
        if (rows.isEmpty()) throw Rejection.BadRoster("empty")
        if (rows.size > MOST_STUDENTS) throw Rejection.BadRoster("long", MOST_STUDENTS)
        requireOwnKeys(rows)
        return RosterTable(rows, unused(columns, table.map { it.value }))
    }

    private fun unused(
        columns: List<RosterColumn?>,
        table: List<List<String>>,
    ): List<String> =
        columns.indices.filter { columns[it] == null }.mapNotNull { at ->
            val heading = table.first()[at].trim()
            val says = table.any { it.getOrElse(at) { "" }.isNotBlank() }
            if (says) heading.ifEmpty { "#${at + 1}" } else null
        }

    private val NAMING =
        setOf(RosterColumn.FULL_NAME, RosterColumn.CANVAS_NAME, RosterColumn.FIRST_NAME, RosterColumn.LAST_NAME)

    private fun row(
        line: Int,
        columns: List<RosterColumn?>,
        cells: List<String>,
    ): RosterRow? {
        val told =
            columns
                .zip(cells)
                .mapNotNull { (column, cell) -> column?.let { it to cell.trim() } }
                .filter { it.second.isNotEmpty() }
                .toMap()
        val student = told[RosterColumn.CANVAS_NAME]
        if (RosterColumn.CANVAS_NAME in columns && student.orEmpty().lowercase() in NOBODY) return null
        val name = told[RosterColumn.FULL_NAME] ?: student?.let(::inOrder) ?: joined(told)
        val checked =
            try {
                Name.of(name)
            } catch (bad: Rejection.BadName) {
                throw Rejection.BadRoster("name", line, name.take(40))
            }
        return RosterRow(line, checked, told.filterKeys { it.kind.isNotEmpty() }.mapKeys { it.key.kind })
    }

    /** "First Last" of "Last, First". */
    private fun inOrder(student: String) =
        student
            .split(",", limit = 2)
            .map(String::trim)
            .reversed()
            .joinToString(" ")

    private fun joined(told: Map<RosterColumn, String>) =
        listOf(RosterColumn.FIRST_NAME, RosterColumn.MIDDLE_NAME, RosterColumn.LAST_NAME)
            .mapNotNull(told::get)
            .joinToString(" ")

    private fun requireOwnKeys(rows: List<RosterRow>) {
        val seen = HashMap<Pair<String, String>, Int>()
        for (row in rows) {
            for ((kind, value) in row.keys) {
                val earlier = seen.put(kind to value.lowercase(), row.line) ?: continue
                throw Rejection.BadRoster("same", earlier, row.line, value)
            }
        }
    }
}
