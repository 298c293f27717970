package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import java.time.InstantSource

/**
 * A student whom a roster brings.
 *
 * @param token that lets the student in, told this once; null in a preview
 * @param known what the roster says besides the name, by [RosterColumn.kind]
 */
data class RosterAddition(
    val student: String?,
    val name: String,
    val token: String?,
    val known: Map<String, String>,
)

/**
 * Something that a roster says anew.
 *
 * @param from what an earlier roster said; null where none said it
 */
data class FieldChange(
    val field: String,
    val from: String?,
    val to: String,
)

/**
 * A student of whom the roster says something new, from one name to another or the same.
 *
 * @param known all that is known then besides the name, by [RosterColumn.kind]
 */
data class RosterCorrection(
    val student: String,
    val from: String,
    val to: String,
    val changes: List<FieldChange>,
    val known: Map<String, String>,
)

/**
 * Tells what a roster changes, or would change.
 *
 * @param missing students of the course who are not in the roster; they stay
 * @param unused the headings of the columns of which nothing is taken
 */
data class RosterChange(
    val added: List<RosterAddition>,
    val corrected: List<RosterCorrection>,
    val unchanged: Int,
    val missing: List<Enrolled>,
    val unused: List<String>,
)

/**
 * Brings a course's students to what a roster says. A student is known again by what only one has, such as an address,
 * or else by the name; nobody is taken out.
 */
class RosterImport(
    private val database: Database,
    private val clock: InstantSource,
) {
    /**
     * Applies a roster, or with [dry] says only what would change.
     *
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it gives the same answer with the same tokens
     */
    fun apply(
        course: Course,
        roster: ByteArray,
        dry: Boolean,
        by: String,
        key: String?,
    ): RosterChange {
        val table = Roster.read(roster)
        if (dry) return database.read { plan(it, course, table).change(null) }
        val owner = "roster ${course.id} $by"
        val request = Repeatable(owner, key, String(roster, Charsets.ISO_8859_1))
        return database.write { handle ->
            val tokens = key?.let { Secrets.derive(handle, "$owner $it") }
            val token = { row: RosterRow -> tokens?.let { Secrets.hash("$it ${row.line}") } ?: Secrets.newToken() }
            request.made(handle)?.let {
                return@write KeptRosterChange.of(it).again(table, Courses.enrolled(handle, course.id), token)
            }
            val plan = plan(handle, course, table)
            val rows = StudentRows(handle, course.id, clock.instant())
            val change = plan.change(rows, token)
            rows.write()
            val detail = "added ${change.added.size}, corrected ${change.corrected.size}"
            AuditNote(by, course.id, "roster", subject = "", detail).write(handle, clock.instant())
            request.remember(handle, KeptRosterChange.of(change, plan.lines(change)).text(), clock.instant())
            change
        }
    }

    private fun plan(
        handle: Handle,
        course: Course,
        table: RosterTable,
    ): Plan {
        val students = Courses.enrolled(handle, course.id)
        val byKey =
            students
                .flatMap { student -> student.fields.map { (it.key to it.value.lowercase()) to student } }
                .toMap()
        val named = students.groupBy { Name.spaced(it.name) }
        val matches = LinkedHashMap<RosterRow, Enrolled>()
        val taken = HashMap<String, RosterRow>()
        for (row in table.rows) {
            val found =
                row.keys.firstNotNullOfOrNull { byKey[it.first to it.second.lowercase()] }
                    ?: byName(row, named[row.name.text].orEmpty())
                    ?: continue
            taken.put(found.id, row)?.let { throw Rejection.BadRoster("both", it.line, row.line, found.shownName) }
            matches[row] = found
        }
        return Plan(table, matches, students.filter { it.id !in taken })
    }

    /** The student of that name, unless a roster said before that this is somebody else. */
    private fun byName(
        row: RosterRow,
        candidates: List<Enrolled>,
    ): Enrolled? {
        val possible = candidates.filter { one -> row.keys.none { (kind, _) -> kind in one.fields } }
        if (possible.size > 1) throw Rejection.BadRoster("ambiguous", row.line, row.name.text)
        return possible.singleOrNull()
    }

    private class Plan(
        val table: RosterTable,
        val matches: Map<RosterRow, Enrolled>,
        val missing: List<Enrolled>,
    ) {
        private val news = table.rows.filter { it !in matches }

        /** The line of the roster about each student, after the [change]. */
        fun lines(change: RosterChange): Map<String, Int> =
            matches.entries.associate { (row, student) -> student.id to row.line } +
                change.added.zip(news).associate { (one, row) -> one.student.orEmpty() to row.line }

        /**
         * @param rows what writes it, or null for a preview
         * @param token of a new student
         */
        fun change(
            rows: StudentRows?,
            token: (RosterRow) -> String = { "" },
        ): RosterChange {
            val corrected = matches.mapNotNull { (row, student) -> correction(row, student, rows) }
            val added = news.map { addition(it, rows, token) }
            return RosterChange(added, corrected, matches.size - corrected.size, missing, table.unused)
        }

        private fun correction(
            row: RosterRow,
            student: Enrolled,
            rows: StudentRows?,
        ): RosterCorrection? {
            val before = student.fields
            val news = row.fields.filter { (kind, value) -> before[kind] != value }
            val renamed = row.name.text != student.name
            if (news.isEmpty() && !renamed) return null
            if (renamed) rows?.rename(student.id, student.number, row.name)
            rows?.note(student.id, news)
            val changes = news.map { (kind, value) -> FieldChange(kind, before[kind], value) }
            return RosterCorrection(student.id, student.name, row.name.text, changes, before + news)
        }

        private fun addition(
            row: RosterRow,
            rows: StudentRows?,
            token: (RosterRow) -> String,
        ): RosterAddition {
            if (rows == null) return RosterAddition(null, row.name.text, null, row.fields)
            val made = token(row)
            val student = rows.add(row.name, made)
            rows.note(student, row.fields)
            return RosterAddition(student, row.name.text, made, row.fields)
        }
    }
}
